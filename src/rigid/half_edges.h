#pragma once

#include <vector>

#include "incision/rigid/triangle_mesh.h"

namespace incision {

/// For each edge of each triangle, from corner k to corner k + 1, a triangle or NO_NEIGHBOUR.
using Neighbours = std::vector<std::array<int, 3>>;

inline constexpr int NO_NEIGHBOUR = -1;

/// Turns triangles over so that those which share an edge with one other agree with it on what is outside, most of
/// them left as they are. Throws InputError where that cannot be, as on a Möbius strip.
void orientAlike(TriangleMesh* mesh);

/// What is across each edge. Where more than two triangles meet at an edge, those two are neighbours that have a wedge
/// of the inside between them: two cubes that meet at an edge stay two.
Neighbours neighboursOf(const TriangleMesh& mesh);

/// Makes a vertex of every ring, or open fan, of neighbours round one.
void splitVertices(const Neighbours& neighbours, TriangleMesh* mesh);

}  // namespace incision
