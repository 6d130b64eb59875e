#pragma once

#include "incision/mesh/grid_settings.h"
#include "incision/mesh/tet_mesh.h"

namespace incision {

/// A box of cells, each split into the six Kuhn tetrahedra round its diagonal from the smallest to the largest corner.
/// Node (i, j, k) has index (i (ny + 1) + j)(nz + 1) + k.
TetMesh gridMesh(const GridSettings& grid);

}  // namespace incision
