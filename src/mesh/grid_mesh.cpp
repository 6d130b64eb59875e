#include "incision/mesh/grid_mesh.h"

#include <cmath>
#include <sstream>

#include "incision/base/input_error.h"
#include "incision/base/limits.h"
#include "limits.h"

namespace incision {
namespace {

/// Cells in a grid. Four million are 24 million tetrahedra, more than the machines this runs on can simulate; the limit
/// keeps a slip of the pen from filling the memory, and every index within an int.
constexpr int MAX_CELLS = 4'000'000;

/// Axes in the order in which a Kuhn tetrahedron walks from the smallest to the largest corner of its cell.
struct KuhnPath {
  std::array<int, 3> axes;
  bool even;  ///< permutation of the axes; the walk along an even one gives a positive volume
};

constexpr std::array<KuhnPath, 6> KUHN_PATHS = {{{{0, 1, 2}, true},
                                                 {{0, 2, 1}, false},
                                                 {{1, 0, 2}, false},
                                                 {{1, 2, 0}, true},
                                                 {{2, 0, 1}, true},
                                                 {{2, 1, 0}, false}}};

void check(const GridSettings& grid) {
  const auto fail = [](const char* key, const auto& value, const std::string& allowed) {
    std::ostringstream message;
    message << "grid." << key << ": [" << value[0] << ", " << value[1] << ", " << value[2] << "]: " << allowed;
    throw InputError(message.str());
  };
  double cells = 1;
  for (int i = 0; i < 3; ++i) {
    if (grid.cells[i] < 1) fail("cells", grid.cells, "each must be at least 1");
    if (!std::isfinite(grid.size[i]) || grid.size[i] <= 0) fail("size", grid.size, "each must be finite and above 0");
    if (!std::isfinite(grid.origin[i])) fail("origin", grid.origin, "each must be finite");
    if (std::abs(grid.origin[i]) + grid.size[i] > MAX_COORDINATE)
      fail("size", grid.size, "the grid must stay within coordinates of 1e9 m");
    cells *= grid.cells[i];
  }
  if (cells > MAX_CELLS) fail("cells", grid.cells, "at most " + std::to_string(MAX_CELLS) + " in all");
}

std::vector<Vec3> gridNodes(const GridSettings& grid) {
  const auto [nx, ny, nz] = grid.cells;
  std::vector<Vec3> nodes;
  nodes.reserve(static_cast<std::size_t>(nx + 1) * (ny + 1) * (nz + 1));
  for (int i = 0; i <= nx; ++i)
    for (int j = 0; j <= ny; ++j)
      for (int k = 0; k <= nz; ++k)
        nodes.push_back(grid.origin + Vec3(i * grid.size.x() / nx, j * grid.size.y() / ny, k * grid.size.z() / nz));
  return nodes;
}

}  // namespace

TetMesh gridMesh(const GridSettings& grid) {
  check(grid);
  TetMesh mesh;
  mesh.nodes = gridNodes(grid);

  const auto [nx, ny, nz] = grid.cells;
  const std::array<int, 3> stride = {(ny + 1) * (nz + 1), nz + 1, 1};
  mesh.elements.reserve(static_cast<std::size_t>(6) * nx * ny * nz);
  for (int i = 0; i < nx; ++i) {
    for (int j = 0; j < ny; ++j) {
      for (int k = 0; k < nz; ++k) {
        const int a = i * stride[0] + j * stride[1] + k;
        for (const auto& [axes, even] : KUHN_PATHS) {
          const int b = a + stride[axes[0]];
          const int c = b + stride[axes[1]];
          const int d = c + stride[axes[2]];
          if (even)
            mesh.elements.push_back({a, b, c, d});
          else
            mesh.elements.push_back({a, b, d, c});
        }
      }
    }
  }
  for (const auto& n : mesh.elements)
    if (isDegenerate(mesh.nodes[n[0]], mesh.nodes[n[1]], mesh.nodes[n[2]], mesh.nodes[n[3]]))
      throw InputError(
          "grid.size: the cells are too small, or too thin for their length or their distance from the origin");
  return mesh;
}

}  // namespace incision
