#pragma once

#include <cstdint>

namespace incision {

/// A kind of element in Gmsh's files. Its corners come first among its nodes.
struct GmshElement {
  int type;           ///< Gmsh's number
  const char* shape;  ///< in the plural, without the order
  int dimension;      ///< 0 … 3
  int order;          ///< of its functions
  int corners, nodes;
  bool isTetrahedron() const { return dimension == 3 && corners == 4; }
};

/// The elements of Gmsh's manual ("MSH file format", element types 1 to 31, 92 and 93) and the quadrangles beyond; null
/// for other types.
const GmshElement* findGmshElement(std::int64_t type);

}  // namespace incision
