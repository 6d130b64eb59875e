#pragma once

#include <vector>

namespace incision {

/// A side of a polygon of the surface, from one vertex to the next.
struct SurfaceEdge {
  int from, to;
  int part;  ///< whose polygon it is
};

/// The gaps that polygons leave between them: loops of edges whose reverse no polygon has, each visiting a vertex once.
/// `edges` are all sides of closed polygons over the vertices 0 … num_vertices − 1.
std::vector<std::vector<SurfaceEdge>> findGaps(const std::vector<SurfaceEdge>& edges, int num_vertices);

}  // namespace incision
