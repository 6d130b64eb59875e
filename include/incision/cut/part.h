#pragma once

#include <Eigen/Core>
#include <vector>

namespace incision {

/// The weights N_I (I = 0 … 3) of an element's nodes at a point; they sum to 1.
using Barycentric = Eigen::Vector4d;

/// One flat side of a polytope.
struct Facet {
  std::vector<int> corners;  ///< counter-clockwise seen from outside, in an element of positive orientation
  int face;                  ///< the element's face it lies in, named by the opposite local node; −1: a cut face
  int crack;                 ///< the crack that made it when it is a cut face, else −1
};

/// The convex region of a part within its element. Corners on a face of the element have an exact zero there.
struct Polytope {
  std::vector<Barycentric> corners;
  std::vector<Facet> facets;

  /// The facet on the element's face `face`, or null when the part has none there.
  const Facet* onFace(int face) const;
};

const Polytope& wholeElement();

/// Moments of a polytope, as shares of the element's volume V_e.
struct PolytopeMoments {
  double fraction;           ///< V_p / V_e
  Barycentric centroid;
  Eigen::Matrix4d products;  ///< ∫_p N_I N_J dX / V_e
};
PolytopeMoments moments(const Polytope& polytope);

/// Sign of a linear function at every corner: −1, 0 or 1; within `zero` of 0 it is 0.
std::vector<signed char> cornerSigns(const Polytope& polytope, const Eigen::Vector4d& phi, double zero);

/// The two convex halves on either side of φ = 0, joined along the section that crack `crack` makes.
struct Halves {
  Polytope positive, negative;
};
Halves split(const Polytope& polytope, const Eigen::Vector4d& phi, const std::vector<signed char>& signs, int crack);

/// Corners of the section φ = 0 of a polytope that has corners of both signs, in order round it.
std::vector<Barycentric> section(const Polytope& polytope, const Eigen::Vector4d& phi,
                                 const std::vector<signed char>& signs);

/// Centroid by area of a flat convex polygon of at least three corners; with no area, the mean of its corners.
Barycentric polygonCentroid(const std::vector<Barycentric>& polygon);

/// A polygon on an element's face as weights of three of its nodes, and its share of the face's area.
using FacePoint = Eigen::Vector3d;
double faceShare(const std::vector<FacePoint>& polygon);

/// Common region of two convex polygons on the same face, both counter-clockwise in the same sense.
std::vector<FacePoint> overlap(const std::vector<FacePoint>& a, const std::vector<FacePoint>& b);

}  // namespace incision
