#pragma once

#include <vector>

#include "incision/cut/cut_mesh.h"

namespace incision {

/// Where a point of a part is [m] while the copies stand at `x` [m]: Σ_I N_I x_{c(p,I)}.
inline Vec3 at(const Part& part, const Barycentric& point, const std::vector<Vec3>& x) {
  Vec3 sum = Vec3::Zero();
  for (int I = 0; I < 4; ++I) sum += point[I] * x[part.copies[I]];
  return sum;
}

/// Where a point of an element is at rest [m]: Σ_I N_I X_I.
inline Vec3 atRest(const CutMesh& mesh, int element, const Barycentric& point) {
  Vec3 sum = Vec3::Zero();
  for (int I = 0; I < 4; ++I) sum += point[I] * mesh.mesh().nodes[mesh.mesh().elements[element][I]];
  return sum;
}

}  // namespace incision
