#pragma once

#include <array>
#include <vector>

#include "incision/mesh/tet_mesh.h"

namespace incision {

/// The search for the best triangles is cubic in the number of corners: 50 µs for this many. Polygons with more, beside
/// an element cut dozens of times, are halved first.
inline constexpr int MAX_BEST_CORNERS = 32;

/// Triangulates a flat convex polygon of at least three corners, some of which may lie on straight sides. Up to
/// MAX_BEST_CORNERS the worst triangle is as good as can be, so none is flat unless every way has a flat one. Returns
/// indices into `loop`, in its sense of rotation.
std::vector<std::array<int, 3>> triangulate(const std::vector<Vec3>& loop);

}  // namespace incision
