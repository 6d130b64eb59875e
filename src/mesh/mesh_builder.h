#pragma once

#include <array>
#include <cstdint>
#include <map>
#include <string>
#include <unordered_map>
#include <vector>

#include "gmsh_elements.h"
#include "group_builder.h"
#include "incision/base/line_reader.h"
#include "incision/mesh/mesh_io.h"
#include "incision/mesh/tet_mesh.h"

namespace incision {

/// Puts together a mesh from the nodes and elements of a file, in its order, and checks each against what a mesh must
/// be. Errors name the reader's current line, or that of the element in question, and numbers of the file.
class MeshBuilder {
 public:
  explicit MeshBuilder(const LineReader& reader) : reader_(reader) {}

  /// Makes room for what follows.
  void reserveNodes(int count);
  void reserveElements(int count);

  /// A node by its number in the file. Numbers need not be dense nor in order; positions may coincide.
  void addNode(std::int64_t number, const Vec3& position);

  /// The name of a physical group.
  void nameGroup(int dimension, int number, const std::string& name);

  /// A tetrahedron of first or second order by its number in the file, those of its nodes, and those of its physical
  /// groups. Turned when its volume is negative. Numbers of elements may be equal.
  void addTetrahedron(std::int64_t number, const std::vector<std::int64_t>& nodes, const std::vector<int>& groups);

  /// A point, line or surface of this kind in physical groups.
  void addToGroups(const GmshElement& kind, std::int64_t number, const std::vector<std::int64_t>& nodes,
                   const std::vector<int>& groups);

  /// A point, line or surface, in a group or in none.
  void skipElement() { ++repairs_.skipped_elements; }

  /// An element with a volume, but no tetrahedron.
  void addOtherVolume(const GmshElement& kind);

  /// The mesh, once it is seen to hang together.
  TetMesh finish(MeshRepairs& repairs);

 private:
  const std::vector<int>& findNodes(std::int64_t element, const std::vector<std::int64_t>& nodes);
  void checkVolumes() const;
  void mergeRepeated();
  void checkTopology() const;
  std::string called(int element) const;
  int countUnreferencedNodes() const;

  const LineReader& reader_;
  TetMesh mesh_;
  GroupBuilder groups_;
  MeshRepairs repairs_;
  std::unordered_map<std::int64_t, int> node_of_number_;
  std::vector<std::int64_t> node_numbers_, element_numbers_;  // of each node and tetrahedron in the file
  std::vector<int> lines_;                                    // of each tetrahedron
  std::map<std::string, int> other_volumes_;                  // how many there are of each shape
  int other_volume_line_ = 0;                                 // of the first
  std::vector<int> found_;                                    // by findNodes()
};

}  // namespace incision
