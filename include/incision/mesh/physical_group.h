#pragma once

#include <array>
#include <string>
#include <vector>

namespace incision {

/// A physical group of a mesh: elements of one dimension under one name.
struct PhysicalGroup {
  std::string name;   ///< as the file has it; the number as text where the file gives none
  int tag = 0;        ///< its number, which is unique among the groups of its dimension
  int dimension = 3;  ///< of its elements: 0 points, 1 lines, 2 surfaces, 3 volumes

  // Of all these only what tetrahedra use: the corners of its elements, not the nodes between them, and no strays.
  std::vector<int> nodes;                     ///< ascending
  std::vector<std::array<int, 3>> triangles;  ///< of a group of surfaces: nodes ascending, the list sorted, each once
  std::vector<int> elements;                  ///< of a group of volumes: tetrahedra, ascending
};

}  // namespace incision
