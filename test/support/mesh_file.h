#pragma once

#include <sstream>
#include <string>

#include "incision/mesh/tet_mesh.h"

namespace incision::test {

/// A mesh as a Gmsh file of version 2.2, with the groups of surfaces that it has.
inline std::string asGmsh(const TetMesh& mesh) {
  std::ostringstream nodes, elements;
  nodes.precision(17);
  int count = 0;
  for (std::size_t n = 0; n < mesh.nodes.size(); ++n)
    nodes << n + 1 << ' ' << mesh.nodes[n].x() << ' ' << mesh.nodes[n].y() << ' ' << mesh.nodes[n].z() << '\n';
  std::string names;
  for (const PhysicalGroup& group : mesh.groups) {
    names += "2 " + std::to_string(group.tag) + " \"" + group.name + "\"\n";
    for (const auto& [a, b, c] : group.triangles)
      elements << ++count << " 2 2 " << group.tag << " 1 " << a + 1 << ' ' << b + 1 << ' ' << c + 1 << '\n';
  }
  for (const auto& [a, b, c, d] : mesh.elements)
    elements << ++count << " 4 0 " << a + 1 << ' ' << b + 1 << ' ' << c + 1 << ' ' << d + 1 << '\n';
  return "$MeshFormat\n2.2 0 8\n$EndMeshFormat\n$PhysicalNames\n" + std::to_string(mesh.groups.size()) + "\n" + names +
         "$EndPhysicalNames\n$Nodes\n" + std::to_string(mesh.nodes.size()) + "\n" + nodes.str() +
         "$EndNodes\n$Elements\n" + std::to_string(count) + "\n" + elements.str() + "$EndElements\n";
}

}  // namespace incision::test
