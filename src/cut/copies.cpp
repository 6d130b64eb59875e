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
  for (int e : topology.star[node]) {
    const int local = localNode(mesh_.mesh().elements[e], node);
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
  pairs_.resize(faces.size());
  parallelFor(static_cast<int>(faces.size()), mesh.threads(), [&](int i) {
    for (const FacePair& pair : mesh_.facePairs(faces[i].first, faces[i].second))
      if (!pair.severed_by) pairs_[i].emplace_back(pair.part, pair.other);
  });
}

const NodeComponents& ComponentFinder::find(int node) {
  found_.parts.clear();
  found_.local_node.clear();
  for (int e : mesh_.topology().star[node]) {
    const int local = localNode(mesh_.mesh().elements[e], node);
    for (int p = e; p >= 0; p = mesh_.parts()[p].next) {
      index_[p] = static_cast<int>(found_.parts.size());
      found_.parts.push_back(p);
      found_.local_node.push_back(local);
    }
  }
  sets_.reset(static_cast<int>(found_.parts.size()));
  forEachFace(node, [&](int e, int face, int across) {
    const int index = face_index_[4 * e + face];
    if (index < 0) {
      sets_.join(index_[e], index_[across]);
      return;
    }
    for (const auto& [p, q] : pairs_[index]) sets_.join(index_[p], index_[q]);
  });
  found_.count = sets_.enumerate(&found_.component);
  return found_;
}

}  // namespace incision
