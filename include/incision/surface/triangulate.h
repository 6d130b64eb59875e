#pragma once

#include <array>
#include <vector>

#include "incision/mesh/tet_mesh.h"

namespace incision {

/// Triangulates a flat convex polygon that may have corners amid straight sides, such that its worst triangle is as
/// good as can be: no triangle is flat unless all ways have a flat one. Returns indices into `loop`, in its sense of
/// rotation. The time is cubic in the number of corners.
std::vector<std::array<int, 3>> triangulate(const std::vector<Vec3>& loop);

}  // namespace incision
