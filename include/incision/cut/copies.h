#pragma once

#include <unordered_map>
#include <vector>

#include "incision/cut/cut_mesh.h"

namespace incision {

/// The parts round one node, sorted into the sets that hang together.
struct NodeComponents {
  std::vector<int> parts;       ///< ascending within each element of the star
  std::vector<int> local_node;  ///< which of its element's nodes the node is
  std::vector<int> component;   ///< of each part, numbered from 0
  int count = 0;
};

/// Finds them: parts are joined across the faces that contain the node, wherever they overlap by more than MIN_OVERLAP
/// and no crack severs them. Remembers the faces it has looked at, so one finder serves many nodes of an unchanged
/// mesh.
class ComponentFinder {
 public:
  explicit ComponentFinder(const CutMesh& mesh) : mesh_(mesh) {}

  /// The result is valid until the next call.
  const NodeComponents& find(int node);

 private:
  const std::vector<std::pair<int, int>>& joined(int element, int face);
  int root(int i);
  void join(int part, int other);

  const CutMesh& mesh_;
  NodeComponents found_;
  std::vector<int> link_;   // union-find over found_.parts
  std::vector<int> index_;  // of each part of the mesh in found_.parts, where it is in them
  std::unordered_map<long, std::vector<std::pair<int, int>>> faces_;
};

}  // namespace incision
