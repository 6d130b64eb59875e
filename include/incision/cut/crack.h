#pragma once

#include <functional>
#include <optional>
#include <vector>

#include "incision/cut/part.h"
#include "incision/cut/plane_cut.h"

namespace incision {

/// A crack as the cut mesh sees it: a signed distance at the copies, linear in each part, and bounds.
struct CrackField {
  std::optional<int> crack;  ///< the number of the crack that grows; without: a new one
  std::vector<double> phi;   ///< φ [m] at every copy
  std::vector<int> parts;    ///< the parts it may split or sever; empty: all
  /// Whether the crack reaches a section of a part, or a face that lies in it, given as a polygon. Asked from several
  /// threads at once; empty: unbounded.
  std::function<bool(int part, const std::vector<Barycentric>& polygon)> contains;
};

class CutMesh;

/// φ_c = n·(x_c − point) and the rectangle's bounds at the copies' current positions `x` [m]. The field refers to
/// `mesh` and `x`.
CrackField planeField(const PlaneCut& plane, const CutMesh& mesh, const std::vector<Vec3>& x);

}  // namespace incision
