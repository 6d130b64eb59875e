#pragma once

#include <functional>
#include <string>
#include <vector>

#include "incision/cut/part.h"
#include "incision/mesh/tet_mesh.h"

namespace incision {

/// A plane or rectangle given from outside, in the deformed configuration.
struct PlaneCut {
  std::string label;
  Vec3 point = Vec3::Zero();    ///< on the plane; the rectangle's centre [m]
  Vec3 normal = Vec3::UnitX();  ///< towards the positive side; any length but zero
  Vec3 tangent = Vec3::Zero();  ///< direction of `length`; what is parallel to the normal is taken off
  double length = 0;            ///< along the tangent [m]; 0: unbounded
  double width = 0;             ///< along normal × tangent [m]; 0: unbounded

  bool bounded() const { return length > 0 || width > 0; }
};

/// Why this plane cannot be a cut, in words for the one who sent it; empty when it can.
std::string whyInvalid(const PlaneCut& plane);

/// A crack as the cut mesh sees it: a signed distance at the copies, linear in each part, and bounds.
struct CrackField {
  int crack = -1;           ///< the number of the crack that grows; −1: a new one
  std::vector<double> phi;  ///< φ [m] at every copy
  std::vector<int> parts;   ///< the parts it may split or sever; empty: all
  /// Whether the crack reaches a section of a part, or a face that lies in it, given as a polygon. Asked from several
  /// threads at once; empty: unbounded.
  std::function<bool(int part, const std::vector<Barycentric>& polygon)> contains;
};

class CutMesh;

/// φ_c = n·(x_c − point) and the rectangle's bounds at the copies' current positions `x` [m]. The field refers to
/// `mesh` and `x`.
CrackField planeField(const PlaneCut& plane, const CutMesh& mesh, const std::vector<Vec3>& x);

}  // namespace incision
