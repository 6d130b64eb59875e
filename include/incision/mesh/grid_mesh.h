#pragma once

#include <array>

#include "incision/mesh/tet_mesh.h"

namespace incision {

struct GridSettings {
  std::array<int, 3> cells = {1, 1, 1};  ///< along x, y, z; each ≥ 1
  Vec3 size = Vec3::Ones();              ///< of the whole grid [m]; each > 0
  Vec3 origin = Vec3::Zero();            ///< of the corner with the smallest coordinates [m]
};

/// A box of cells, each split into the six Kuhn tetrahedra round its diagonal from the smallest to the largest corner.
/// Node (i, j, k) has index (i (ny + 1) + j)(nz + 1) + k.
TetMesh gridMesh(const GridSettings& grid);

}  // namespace incision
