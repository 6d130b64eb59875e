#pragma once

#include <vector>

#include "incision/cut/cut_mesh.h"
#include "incision/fem/boundary_settings.h"

namespace incision {

/// Index of the first clamp that has the node, or −1, for every node. Throws InputError where a group is missing.
std::vector<int> heldNodes(const TetMesh& mesh, const std::vector<Clamp>& clamps);

/// The clamp of every copy, or −1. A copy of a held node is held when it is the own copy, or when its parts own area of
/// a boundary face, or volume of an element, all of whose nodes are held by clamps that move as the node's does.
std::vector<int> heldCopies(const CutMesh& mesh, const std::vector<Clamp>& clamps, const std::vector<int>& held_nodes);

}  // namespace incision
