#pragma once

#include <vector>

#include "incision/mesh/tet_mesh.h"

namespace incision {

/// An order of a mesh's nodes in which neighbours are close, found by halving the body at rest.
struct NodeOrder {
  std::vector<int> rank;  ///< place of each node in the order
  std::vector<int> leaf;  ///< number of the compact group of about `leaf_size` nodes each belongs to, ascending by rank
  int leaf_size = 0, leaves = 0;
};

NodeOrder orderNodes(const TetMesh& mesh, int leaf_size);

/// Sorts the elements so that neighbours are close in memory.
void orderElements(TetMesh* mesh);

}  // namespace incision
