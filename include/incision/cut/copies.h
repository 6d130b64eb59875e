#pragma once

#include <utility>
#include <vector>

#include "incision/base/disjoint_sets.h"
#include "incision/cut/cut_mesh.h"

namespace incision {

/// The parts round one node, sorted into the sets that hang together.
struct NodeComponents {
  std::vector<int> parts;       ///< ascending within each element of the star
  std::vector<int> local_node;  ///< which of its element's nodes the node is
  std::vector<int> component;   ///< of each part, numbered from 0 by their first parts
  int count = 0;
};

/// Finds the components round the given nodes of a mesh that does not change meanwhile: parts are joined across the
/// faces that contain the node, wherever they overlap by more than MIN_OVERLAP and no crack severs them.
class ComponentFinder {
 public:
  ComponentFinder(const CutMesh& mesh, const std::vector<int>& nodes);

  /// `node` is one of the given nodes. The result is valid until the next call.
  const NodeComponents& find(int node);

 private:
  template <typename Function>
  void forEachFace(int node, const Function& f) const;

  const CutMesh& mesh_;
  NodeComponents found_;
  DisjointSets sets_;       // of found_.parts, by their places there
  std::vector<int> index_;  // of each part of the mesh in found_.parts, where it is in them
  // Of faces between two elements not both of which are whole: the pairs of parts that hang together there.
  std::vector<int> face_index_;  // by 4 element + face, or −1
  std::vector<std::vector<std::pair<int, int>>> pairs_;
};

}  // namespace incision
