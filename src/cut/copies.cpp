#include "incision/cut/copies.h"

#include <algorithm>

namespace incision {
namespace {

int localNode(const std::array<int, 4>& element, int node) {
  return static_cast<int>(std::find(element.begin(), element.end(), node) - element.begin());
}

}  // namespace

const NodeComponents& ComponentFinder::find(int node) {
  const MeshTopology& topology = mesh_.topology();
  found_.parts.clear();
  found_.local_node.clear();
  const int first = topology.star_start[node], last = topology.star_start[node + 1];
  for (int s = first; s < last; ++s) {
    const int e = topology.star[s], local = localNode(mesh_.mesh().elements[e], node);
    for (int p = e; p >= 0; p = mesh_.parts()[p].next) {
      found_.parts.push_back(p);
      found_.local_node.push_back(local);
    }
  }
  link_.resize(found_.parts.size());
  index_.resize(mesh_.parts().size());
  for (std::size_t i = 0; i < link_.size(); ++i) link_[i] = index_[found_.parts[i]] = static_cast<int>(i);

  for (int s = first; s < last; ++s) {
    const int e = topology.star[s], local = localNode(mesh_.mesh().elements[e], node);
    for (int f = 0; f < 4; ++f) {
      const int across = topology.neighbours[e][f];
      if (f == local || across <= e) continue;
      if (mesh_.isWhole(e) && mesh_.isWhole(across))
        join(e, across);
      else
        for (const auto& [p, q] : joined(e, f)) join(p, q);
    }
  }

  found_.component.assign(link_.size(), -1);
  found_.count = 0;
  for (std::size_t i = 0; i < link_.size(); ++i) {
    const int r = root(static_cast<int>(i));
    if (found_.component[r] < 0) found_.component[r] = found_.count++;
    found_.component[i] = found_.component[r];
  }
  return found_;
}

const std::vector<std::pair<int, int>>& ComponentFinder::joined(int element, int face) {
  const auto [entry, added] = faces_.try_emplace(4L * element + face);
  if (added)
    for (const FacePair& pair : mesh_.facePairs(element, face))
      if (!pair.severed) entry->second.emplace_back(pair.part, pair.other);
  return entry->second;
}

int ComponentFinder::root(int i) {
  while (link_[i] != i) i = link_[i] = link_[link_[i]];
  return i;
}

void ComponentFinder::join(int part, int other) {
  const int a = root(index_[part]), b = root(index_[other]);
  // The lower index stays the root, so components are numbered by their first part.
  link_[std::max(a, b)] = std::min(a, b);
}

}  // namespace incision
