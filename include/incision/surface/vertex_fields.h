#pragma once

#include <array>
#include <vector>

#include "incision/surface/surface.h"

namespace incision {

/// Of a triangle whose vertices are among those at `x` [m], by the sense in which its corners run [m²].
Vec3 vectorArea(const std::array<int, 3>& triangle, const std::vector<Vec3>& x);

/// Unit normals at the vertices of a surface whose vertices are at `x` [m]: the mean of those of the triangles round
/// each, by their areas; zero where these are flat or cancel.
std::vector<Vec3> vertexNormals(const Surface& surface, const std::vector<Vec3>& x);

/// Values at the vertices: the mean of those of the triangles round each, by their areas; the plain mean where they
/// have none. `of_triangle` has one value for each triangle.
std::vector<double> vertexMeans(const Surface& surface, const std::vector<Vec3>& x,
                                const std::vector<double>& of_triangle);

}  // namespace incision
