#include "incision/cut/copies.h"

#include <algorithm>

#include "incision/base/parallel.h"

namespace incision {
namespace {

int localNode(const std::array<int, 4>& element, int node) {
  return static_cast<int>(std::find(element.begin(), element.end(), node) - element.begin());
}

}  // namespace

/// Calls f(element, face, element across) for every inner face that contains the node, from one of its sides.
template <typename Function>
void ComponentFinder::forEachFace(int node, const Function& f) const {
  const MeshTopology& topology = mesh_.topology();
  for (int s = topology.star_start[node]; s < topology.star_start[node + 1]; ++s) {
    const int e = topology.star[s], local = localNode(mesh_.mesh().elements[e], node);
    for (int face = 0; face < 4; ++face)
      if (const int across = topology.neighbours[e][face]; face != local && across > e) f(e, face, across);
  }
}

ComponentFinder::ComponentFinder(const CutMesh& mesh, const std::vector<int>& nodes)
    : mesh_(mesh), index_(mesh.parts().size()), face_index_(4 * mesh.mesh().elements.size(), -1) {
  std::vector<std::pair<int, int>> faces;
  for (int node : nodes)
    forEachFace(node, [&](int e, int face, int across) {
      int& index = face_index_[4 * e + face];
      if (index >= 0 || (mesh_.isWhole(e) && mesh_.isWhole(across))) return;
      index = static_cast<int>(faces.size());
      faces.emplace_back(e, face);
    });
  joined_.resize(faces.size());
  parallelFor(static_cast<int>(faces.size()), mesh.threads(), [&](int i) {
    for (const FacePair& pair : mesh_.facePairs(faces[i].first, faces[i].second))
      if (!pair.severed) joined_[i].emplace_back(pair.part, pair.other);
  });
}

const NodeComponents& ComponentFinder::find(int node) {
  const MeshTopology& topology = mesh_.topology();
  found_.parts.clear();
  found_.local_node.clear();
  for (int s = topology.star_start[node]; s < topology.star_start[node + 1]; ++s) {
    const int e = topology.star[s], local = localNode(mesh_.mesh().elements[e], node);
    for (int p = e; p >= 0; p = mesh_.parts()[p].next) {
      found_.parts.push_back(p);
      found_.local_node.push_back(local);
    }
  }
  link_.resize(found_.parts.size());
  for (std::size_t i = 0; i < link_.size(); ++i) link_[i] = index_[found_.parts[i]] = static_cast<int>(i);

  forEachFace(node, [&](int e, int face, int across) {
    const int index = face_index_[4 * e + face];
    if (index < 0) return join(e, across);
    for (const auto& [p, q] : joined_[index]) join(p, q);
  });

  found_.component.assign(link_.size(), -1);
  found_.count = 0;
  for (std::size_t i = 0; i < link_.size(); ++i) {
    const int r = root(static_cast<int>(i));
    if (found_.component[r] < 0) found_.component[r] = found_.count++;
    found_.component[i] = found_.component[r];
  }
  return found_;
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
