#include "gmsh_elements.h"

#include <algorithm>
#include <iterator>

namespace incision {
namespace {

constexpr GmshElement ELEMENTS[] = {
    {1, "lines", 1, 1, 2, 2},         {2, "triangles", 2, 1, 3, 3},     {3, "quadrangles", 2, 1, 4, 4},
    {4, "tetrahedra", 3, 1, 4, 4},    {5, "hexahedra", 3, 1, 8, 8},     {6, "prisms", 3, 1, 6, 6},
    {7, "pyramids", 3, 1, 5, 5},      {8, "lines", 1, 2, 2, 3},         {9, "triangles", 2, 2, 3, 6},
    {10, "quadrangles", 2, 2, 4, 9},  {11, "tetrahedra", 3, 2, 4, 10},  {12, "hexahedra", 3, 2, 8, 27},
    {13, "prisms", 3, 2, 6, 18},      {14, "pyramids", 3, 2, 5, 14},    {15, "points", 0, 1, 1, 1},
    {16, "quadrangles", 2, 2, 4, 8},  {17, "hexahedra", 3, 2, 8, 20},   {18, "prisms", 3, 2, 6, 15},
    {19, "pyramids", 3, 2, 5, 13},    {20, "triangles", 2, 3, 3, 9},    {21, "triangles", 2, 3, 3, 10},
    {22, "triangles", 2, 4, 3, 12},   {23, "triangles", 2, 4, 3, 15},   {24, "triangles", 2, 5, 3, 15},
    {25, "triangles", 2, 5, 3, 21},   {26, "lines", 1, 3, 2, 4},        {27, "lines", 1, 4, 2, 5},
    {28, "lines", 1, 5, 2, 6},        {29, "tetrahedra", 3, 3, 4, 20},  {30, "tetrahedra", 3, 4, 4, 35},
    {31, "tetrahedra", 3, 5, 4, 56},  {36, "quadrangles", 2, 3, 4, 16}, {37, "quadrangles", 2, 4, 4, 25},
    {38, "quadrangles", 2, 5, 4, 36}, {92, "hexahedra", 3, 3, 8, 64},   {93, "hexahedra", 3, 4, 8, 125},
};

}  // namespace

const GmshElement* findGmshElement(std::int64_t type) {
  const auto found =
      std::find_if(std::begin(ELEMENTS), std::end(ELEMENTS), [&](const GmshElement& e) { return e.type == type; });
  return found == std::end(ELEMENTS) ? nullptr : found;
}

}  // namespace incision
