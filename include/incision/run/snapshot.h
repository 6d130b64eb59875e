#pragma once

#include <iosfwd>

#include "incision/body/deformable_body.h"

namespace incision {

/// `x y z` [m] of every mesh node's own copy, in mesh order, a line each.
void writePositions(std::ostream& out, const DeformableBody& body);

/// The deformed surface as VTK's XML unstructured grid, which ParaView opens. Cell data of each triangle: `stress` [Pa]
/// (nine components, row by row), `von_mises` [Pa], `part`, `cut_face` (1 where a crack made it) and `piece`.
void writeSnapshot(std::ostream& out, const DeformableBody& body);

}  // namespace incision
