#pragma once

#include <iosfwd>
#include <vector>

#include "incision/body/deformable_body.h"

namespace incision {

/// `x y z` [m] of every mesh node's own copy, in mesh order, a line each.
void writePositions(std::ostream& out, const DeformableBody& body);

/// The deformed surface as VTK's XML unstructured grid, which ParaView opens: triangles, with the data of their parts
/// and `cut_face` (1 where a crack made it).
void writeSnapshot(std::ostream& out, const DeformableBody& body);

/// The deformed parts likewise: tetrahedra, and polyhedra where a crack has cut an element, with the data of each part
/// and the `displacement` [m] of each corner.
void writeVolumeSnapshot(std::ostream& out, const DeformableBody& body);

/// Cell data of cells that belong to these parts: `stress` [Pa] (nine components, row by row), `von_mises` [Pa],
/// `part`, `region` and `piece`.
void writePartData(std::ostream& out, const DeformableBody& body, const std::vector<int>& parts);

}  // namespace incision
