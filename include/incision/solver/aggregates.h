#pragma once

#include <vector>

#include "incision/base/lists.h"
#include "incision/fem/block_pattern.h"
#include "incision/mesh/node_order.h"

namespace incision {

/// Nodes in a leaf of the order that aggregates are made from, for a body of so many nodes. Smaller groups make the
/// coarse matrix dear, larger ones the iterations many: 64 was best at 3k nodes, 96 to 128 at 19k, 128 to 256 at 176k.
int leafSize(int nodes);

/// The rows of a system in groups that are compact and hang together.
struct Aggregates {
  Lists<int> rows;      ///< of each aggregate, ascending
  std::vector<int> of;  ///< the aggregate of each row
  int count() const { return rows.count(); }
};

/// Those copies that are not left out, by the rank of their node; copies of one node ascend.
std::vector<int> orderCopies(const CutMesh& mesh, const NodeOrder& order, const std::vector<bool>& left_out);

/// The leaves, split where no block connects their rows, so that no group spans two pieces. Leaves with many more
/// copies than nodes are split further. Groups too small to carry rigid rotations join a neighbour where they have one.
Aggregates aggregate(const CutMesh& mesh, const NodeOrder& order, const BlockPattern& pattern);

}  // namespace incision
