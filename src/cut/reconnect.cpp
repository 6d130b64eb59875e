#include <algorithm>

#include "incision/cut/copies.h"
#include "incision/cut/cut_mesh.h"

namespace incision {
namespace {

/// How positive a component is at a crack, by its parts that hold the node: the better of two has the higher highest
/// side, or as high a one and the higher lowest.
struct Rank {
  int highest = -2, lowest = 2;  // holds nothing
  void add(int side) {
    highest = std::max(highest, side);
    lowest = std::min(lowest, side);
  }
  bool operator>(const Rank& other) const {
    return highest != other.highest ? highest > other.highest : lowest > other.lowest;
  }
};

}  // namespace

/// Gives every component round the nodes a copy of its own. The own copy stays with the component that holds the node
/// and is most positive; an extended copy with its first component. `side` tells of each part on which side of
/// the new crack it lies, 0 where it does not touch it. Returns the parts whose copies changed.
std::vector<int> CutMesh::reconnect(const std::vector<int>& nodes, const std::vector<signed char>& side) {
  std::vector<int> changed;
  ComponentFinder finder(*this, nodes);
  std::vector<int> old_copy, new_copy, keeper;
  std::vector<Rank> rank;
  for (int node : nodes) {
    const NodeComponents& found = finder.find(node);
    if (found.count == 1) continue;
    old_copy.assign(found.count, -1);
    rank.assign(found.count, Rank());
    for (std::size_t i = 0; i < found.parts.size(); ++i) {
      const int part = found.parts[i], c = found.component[i];
      old_copy[c] = parts_[part].copies[found.local_node[i]];
      if (old_copy[c] != own_copy_[node] || !holdsNode(part, found.local_node[i])) continue;
      rank[c].add(side.empty() ? 0 : side[part]);
    }
    keeper.clear();  // the first component of the highest rank, for each old copy
    for (int c = 0; c < found.count; ++c) {
      const auto same = std::find_if(keeper.begin(), keeper.end(), [&](int k) { return old_copy[k] == old_copy[c]; });
      if (same == keeper.end())
        keeper.push_back(c);
      else if (rank[c] > rank[*same])
        *same = c;
    }
    new_copy.resize(found.count);
    for (int c = 0; c < found.count; ++c) {
      new_copy[c] = old_copy[c];
      if (std::find(keeper.begin(), keeper.end(), c) != keeper.end()) continue;
      new_copy[c] = numCopies();
      copy_node_.push_back(node);
      copy_parent_.push_back(old_copy[c]);
    }
    for (std::size_t i = 0; i < found.parts.size(); ++i) {
      int& copy = parts_[found.parts[i]].copies[found.local_node[i]];
      if (copy == new_copy[found.component[i]]) continue;
      journal_.keepPart(parts_, found.parts[i]);
      copy = new_copy[found.component[i]];
      changed.push_back(found.parts[i]);
    }
  }
  return changed;
}

}  // namespace incision
