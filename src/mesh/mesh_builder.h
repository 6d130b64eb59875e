#pragma once

#include <array>
#include <cstdint>
#include <unordered_map>
#include <unordered_set>
#include <vector>

#include "incision/base/line_reader.h"
#include "incision/mesh/mesh_io.h"
#include "incision/mesh/tet_mesh.h"

namespace incision {

/// Puts together a mesh from the nodes and elements of a file, in its order, and checks each against what a mesh must
/// be. Errors name the reader's current line, or that of the element in question.
class MeshBuilder {
 public:
  explicit MeshBuilder(const LineReader& reader) : reader_(reader) {}

  /// Makes room for what follows.
  void reserveNodes(int count);
  void reserveElements(int count);

  /// A node by its number in the file. Numbers need not be dense nor in order; positions may coincide.
  void addNode(std::int64_t tag, const Vec3& position);

  /// A tetrahedron by its number in the file and those of its nodes. Turned when its volume is negative.
  void addTetrahedron(std::int64_t tag, const std::array<std::int64_t, 4>& node_tags);

  /// An element that is no four-node tetrahedron.
  void skipElement(std::int64_t tag);

  /// The mesh, once it is seen to hang together.
  TetMesh finish(MeshRepairs& repairs);

 private:
  void claimElementTag(std::int64_t tag);
  void checkDuplicates() const;
  void checkTopology() const;
  int countUnreferencedNodes() const;

  const LineReader& reader_;
  TetMesh mesh_;
  MeshRepairs repairs_;
  std::unordered_map<std::int64_t, int> node_of_tag_;
  std::unordered_set<std::int64_t> element_tags_;
  std::vector<int> lines_;  // of each tetrahedron
};

}  // namespace incision
