#pragma once

#include <array>
#include <vector>

#include "incision/cut/cut_mesh.h"

namespace incision {

/// A surface vertex follows the part it sits on: x = Σ_I weights[I] x_copies[I]. Entries beyond the ones needed have
/// weight 0 and repeat a used copy.
struct SurfaceVertex {
  std::array<int, 4> copies;
  Barycentric weights;
};

/// The closed, outward-oriented surface of all pieces. Every edge of a triangle is an edge of exactly one other
/// triangle, run the other way; no two pieces share a vertex.
struct Surface {
  std::vector<SurfaceVertex> vertices;        ///< x_surface = W x, one row of W each
  std::vector<std::array<int, 3>> triangles;  ///< counter-clockwise seen from outside
  std::vector<int> part;                      ///< of each triangle: the part it bounds
  std::vector<bool> cut_face;                 ///< of each triangle: made by a crack, not the body's skin
};

Surface buildSurface(const CutMesh& mesh);

/// W x for the copies' positions `x` [m].
std::vector<Vec3> surfacePositions(const Surface& surface, const std::vector<Vec3>& x);

/// Signed volume enclosed by the surface [m³].
double enclosedVolume(const Surface& surface, const std::vector<Vec3>& positions);

}  // namespace incision
