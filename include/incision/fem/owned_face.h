#pragma once

#include "incision/cut/cut_mesh.h"

namespace incision {

/// Corners of what a part owns of an element's face, as weights of the face's nodes; empty when it owns nothing.
FacePolygon ownedFace(const CutMesh& mesh, int part, int face);

}  // namespace incision
