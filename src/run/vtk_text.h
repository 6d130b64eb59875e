#pragma once

#include <cstddef>
#include <ostream>
#include <string>

#include "incision/base/vec.h"

namespace incision {

// Numbers of VTK's cell types.
inline constexpr int VTK_TRIANGLE = 5, VTK_TETRAHEDRON = 10, VTK_POLYHEDRON = 42;

/// Numbers parted by spaces, as VTK's XML has vectors.
template <class Vector>
void writeRow(std::ostream& out, const Vector& values, int count) {
  for (int i = 0; i < count; ++i) out << (i ? " " : "") << values[i];
}

/// A matrix, row by row.
inline void writeMatrix(std::ostream& out, const Mat3& matrix) {
  for (int row = 0; row < 3; ++row)
    out << (row ? " " : "") << matrix(row, 0) << ' ' << matrix(row, 1) << ' ' << matrix(row, 2);
}

/// One VTK array; `write(i)` puts the i-th entry, its components parted by spaces.
template <class Write>
void writeArray(std::ostream& out, const char* type, const char* name, int components, std::size_t count,
                const Write& write) {
  out << "<DataArray type=\"" << type << "\" Name=\"" << name << "\" format=\"ascii\"";
  if (components > 1) out << " NumberOfComponents=\"" << components << '"';
  out << ">\n";
  for (std::size_t i = 0; i < count; ++i) {
    write(i);
    out << '\n';
  }
  out << "</DataArray>\n";
}

/// An unstructured grid of one piece, whose content `write()` puts.
template <class Write>
void writeGrid(std::ostream& out, std::size_t points, std::size_t cells, const Write& write) {
  out << "<?xml version=\"1.0\"?>\n<VTKFile type=\"UnstructuredGrid\" version=\"1.0\" byte_order=\"LittleEndian\">\n"
      << "<UnstructuredGrid>\n<Piece NumberOfPoints=\"" << points << "\" NumberOfCells=\"" << cells << "\">\n";
  write();
  out << "</Piece>\n</UnstructuredGrid>\n</VTKFile>\n";
}

}  // namespace incision
