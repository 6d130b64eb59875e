#pragma once

#include <Eigen/Core>
#include <optional>
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

template <class Archive>
void serialize(Archive& archive, Facet& facet) {
  auto& [corners, face, crack] = facet;
  archive(corners, face, crack);
}

/// The convex region of a part within its element. Corners on a face of the element have an exact zero there.
struct Polytope {
  std::vector<Barycentric> corners;
  std::vector<Facet> facets;

  /// The facet on the element's face `face`, or null when the part has none there.
  const Facet* onFace(int face) const;
};

template <class Archive>
void serialize(Archive& archive, Polytope& polytope) {
  auto& [corners, facets] = polytope;
  archive(corners, facets);
}

/// The part of an element that no crack has met.
const Polytope& wholeElement();

/// Moments of a polytope, as shares of the element's volume V_e.
struct PolytopeMoments {
  double fraction;  ///< V_p / V_e, > 0
  Barycentric centroid;
  Eigen::Matrix4d products;  ///< ∫_p N_I N_J dX / V_e
};
PolytopeMoments moments(const Polytope& polytope);

/// Sign of a linear function at every corner: −1, 0 or 1; within `zero` of 0 it is 0.
std::vector<signed char> cornerSigns(const Polytope& polytope, const Eigen::Vector4d& phi, double zero);

/// What a crack makes of a polytope.
struct Split {
  Polytope positive, negative;
  std::vector<Barycentric> section;  ///< the polygon that parts them
};

/// Splits along φ = 0 as crack `crack`; `signs` has both signs. Empty when rounding leaves no polygon to split along.
std::optional<Split> split(const Polytope& polytope, const Eigen::Vector4d& phi, const std::vector<signed char>& signs,
                           int crack);

/// Centroid by area of a flat convex polygon of at least three corners; with no area, the mean of its corners.
Barycentric polygonCentroid(const std::vector<Barycentric>& polygon);

}  // namespace incision
