#pragma once

#include <iosfwd>
#include <string>

#include "incision/mesh/tet_mesh.h"

namespace incision {

/// What reading a mesh had to mend or leave out.
struct MeshRepairs {
  int reoriented = 0;          ///< elements given with negative volume, turned by swapping two nodes
  int unreferenced_nodes = 0;  ///< nodes no tetrahedron uses: kept in the list, left out of the system
  int skipped_elements = 0;    ///< entities that are no four-node tetrahedra (points, lines, triangles, …)
};

/// Reads the four-node tetrahedra of a Gmsh ASCII file, version 2.2 or 4.1. Nodes and elements keep the order of the
/// file. Throws InputError "name:line: reason" for anything that is not a valid mesh.
TetMesh readGmsh(const std::string& path, MeshRepairs* repairs = nullptr);
TetMesh readGmsh(std::istream& in, const std::string& name, MeshRepairs* repairs = nullptr);

}  // namespace incision
