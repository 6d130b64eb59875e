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

template <class Archive>
void serialize(Archive& archive, SurfaceVertex& vertex) {
  auto& [copies, weights] = vertex;
  archive(copies, weights);
}

/// The closed, outward-oriented surface of all pieces: every edge of a triangle occurs as often as its reverse, and no
/// two pieces share a vertex. That is once each, but where a crack in the midst of a piece opens on both sides of an
/// edge that itself is whole, as on a strip one element wide: there four triangles meet.
struct Surface {
  std::vector<SurfaceVertex> vertices;        ///< x_surface = W x, one row of W each
  std::vector<std::array<int, 3>> triangles;  ///< counter-clockwise seen from outside
  std::vector<int> part;                      ///< of each triangle: the part it bounds
  std::vector<bool> cut_face;                 ///< of each triangle: made by a crack, not the body's skin
};

/// What bounds the parts and does not hang together with another part across a face; cut faces appear once for each
/// side.
Surface buildSurface(const CutMesh& mesh);

/// Where a vertex is with the copies at `x` [m]: its row of W x.
inline Vec3 positionOf(const SurfaceVertex& vertex, const std::vector<Vec3>& x) {
  Vec3 sum = Vec3::Zero();
  for (int k = 0; k < 4; ++k) sum += vertex.weights[k] * x[vertex.copies[k]];
  return sum;
}

/// W x for the copies' positions `x` [m]; the second form takes any vectors at the copies, up to `threads` threads, and
/// the memory that `result` has.
std::vector<Vec3> surfacePositions(const Surface& surface, const std::vector<Vec3>& x);
void interpolate(const Surface& surface, const std::vector<Vec3>& x, int threads, std::vector<Vec3>* result);

/// Signed volume enclosed by the surface [m³].
double enclosedVolume(const Surface& surface, const std::vector<Vec3>& positions);

}  // namespace incision
