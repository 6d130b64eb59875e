#pragma once

#include <unordered_map>
#include <vector>

#include "incision/mesh/tet_mesh.h"

namespace incision {

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
