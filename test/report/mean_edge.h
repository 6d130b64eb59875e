#pragma once

#include <cmath>

#include "incision/mesh/rest_box.h"
#include "incision/mesh/tet_mesh.h"

namespace incision::report {

/// A crack that ends inside elements acts as if it were shorter by about so many edges of an element.
inline constexpr double MISSING_EDGES = 0.8;

/// Edge [m] of cells of six elements each, of the mean volume in a box.
inline double meanEdge(const TetMesh& mesh, const RestBox& box) {
  double volume = 0;
  int count = 0;
  for (std::size_t e = 0; e < mesh.elements.size(); ++e) {
    Vec3 centre = Vec3::Zero();
    for (int n : mesh.elements[e]) centre += mesh.nodes[n] / 4;
    if (!box.contains(centre)) continue;
    volume += elementVolume(mesh, static_cast<int>(e));
    ++count;
  }
  return std::cbrt(6 * volume / count);
}

}  // namespace incision::report
