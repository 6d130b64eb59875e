#pragma once

#include <map>
#include <string>
#include <utility>
#include <vector>

#include "incision/mesh/tet_mesh.h"

namespace incision {

/// Nodes that some elements of a mesh use, ascending.
std::vector<int> nodesOf(const TetMesh& mesh, const std::vector<int>& elements);

/// Gathers the physical groups of a mesh. Groups go by their dimension and their number, which is above 0.
class GroupBuilder {
 public:
  /// Names a group; false when it has a name already.
  bool name(int dimension, int number, const std::string& name);

  /// Puts an element of points, lines or surfaces into some groups, by its corners.
  void addElement(int dimension, const std::vector<int>& numbers, const std::vector<int>& corners);

  /// Puts a tetrahedron into some groups of volumes.
  void addTetrahedron(const std::vector<int>& numbers, int element);

  /// Element e is now element `now[e]`; several may have become one.
  void renumberElements(const std::vector<int>& now);

  /// The groups in the order that a mesh has them, once it has all of its elements.
  std::vector<PhysicalGroup> finish(const TetMesh& mesh);

 private:
  PhysicalGroup& group(int dimension, int number);

  std::map<std::pair<int, int>, PhysicalGroup> groups_;
};

}  // namespace incision
