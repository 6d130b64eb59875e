#pragma once

#include <array>

#include "incision/mesh/tet_mesh.h"

namespace incision {

/// Nodes of parts of a mesh that share no node, but lie at one place: perhaps the parts were meant to be joined.
struct CoincidentNodes {
  int count = 0;                       ///< nodes that lie where one of another part lies that comes earlier
  std::array<int, 2> pair = {-1, -1};  ///< the first such node, after the one it lies on
};

/// In time linear in the mesh, and little where it is of one part.
CoincidentNodes findCoincidentNodes(const TetMesh& mesh);

}  // namespace incision
