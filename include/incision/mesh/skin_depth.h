#pragma once

#include <unordered_map>
#include <vector>

#include "incision/mesh/tet_mesh.h"

namespace incision {

/// The point of a triangle that is nearest to `point`.
Vec3 nearestOnTriangle(const std::array<Vec3, 3>& triangle, const Vec3& point);

/// How far nodes lie below the mesh's own boundary, at rest. Found when first asked for, in time linear in the
/// boundary.
class SkinDepth {
 public:
  SkinDepth(const TetMesh& mesh, const MeshTopology& topology);

  /// Depth of a node [m]; 0 on the boundary.
  double at(int node);

 private:
  const TetMesh* mesh_;
  std::vector<std::array<Vec3, 3>> faces_;
  std::unordered_map<int, double> known_;
};

}  // namespace incision
