#pragma once

#include <array>
#include <vector>

#include "incision/contact/contact_surface.h"

namespace incision {

/// What is kept of a surface to know its things again when the surface has changed: the vertices by the copies and
/// weights they have, and by their place at rest, as copies of another mesh may have the same numbers; all else by its
/// vertices.
struct SurfaceOutline {
  std::vector<SurfaceVertex> vertices;
  std::vector<Vec3> rest;  ///< of the vertices [m]
  std::vector<std::array<int, 3>> triangles;
  int pieces = 0;
  std::vector<int> vertex_piece;
  std::vector<int> sample_start, around, edge_start;
  std::vector<ContactSurface::Sample> samples;
  std::vector<ContactSurface::Edge> edges;

  SurfaceOutline() = default;
  explicit SurfaceOutline(const ContactSurface& surface);
};

/// What of a surface is the same in another, which has taken its place. A sample or an edge is the same where all
/// triangles round its vertices are.
struct SurfaceMatch {
  /// Of each vertex, triangle, sample, edge there was: its number now, or −1.
  std::vector<int> vertices, triangles, samples, edges;
  /// Of each piece there was: the one that has all it still has, and nothing of another; or −1.
  std::vector<int> pieces;
  /// Those that there were not, ascending.
  std::vector<int> new_triangles, new_samples, new_edges;
};

/// In linear time.
SurfaceMatch match(const SurfaceOutline& before, const ContactSurface& now);

}  // namespace incision
