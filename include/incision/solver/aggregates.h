#pragma once

#include <vector>

#include "incision/cut/cut_mesh.h"

namespace incision {

/// The free copies in groups that are compact and hang together: aggregate a holds copies[start[a]] …
/// copies[start[a + 1] − 1].
struct Aggregates {
  std::vector<int> copies, start;
  int count() const { return static_cast<int>(start.size()) - 1; }
};

/// Groups of about 64 copies, found by halving the body at rest and splitting what no part connects, so that no group
/// spans two pieces. Groups too small to carry rigid rotations join a neighbour where they have one.
Aggregates aggregate(const CutMesh& mesh, const std::vector<bool>& held);

}  // namespace incision
