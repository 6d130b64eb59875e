#pragma once

#include <array>
#include <cstdint>
#include <iosfwd>
#include <string>
#include <vector>

#include "incision/mesh/tet_mesh.h"

namespace incision {

/// What reading a mesh had to mend or leave out, and what of it is perhaps not meant.
struct MeshRepairs {
  int reoriented = 0;             ///< elements given with negative volume, turned by swapping two nodes
  int unreferenced_nodes = 0;     ///< nodes no tetrahedron uses: kept in the list, left out of the system
  int skipped_elements = 0;       ///< points, lines and surfaces: they belong to groups, but have no volume
  int repeated_elements = 0;      ///< tetrahedra of the same nodes as an earlier one, which joins their groups
  int second_order_elements = 0;  ///< tetrahedra of ten nodes, read by their corners

  /// Nodes that lie where one of a part lies that hangs together with theirs by no element, and the numbers that the
  /// first such pair has in the file.
  int coincident_nodes = 0;
  std::array<std::int64_t, 2> coincident_pair = {0, 0};
};

/// What of it a user should know, each in a sentence; nothing where there was nothing to mend.
std::vector<std::string> sentences(const MeshRepairs& repairs);

/// Reads the tetrahedra and the physical groups of a Gmsh ASCII file, version 2.2 or 4.1. Nodes and elements keep the
/// order of the file. Throws InputError "name:line: reason" for anything that is not a valid mesh.
TetMesh readGmsh(const std::string& path, MeshRepairs* repairs = nullptr);
TetMesh readGmsh(std::istream& in, const std::string& name, MeshRepairs* repairs = nullptr);

}  // namespace incision
