#pragma once

#include "incision/mesh/tet_mesh.h"

namespace incision {

/// The rotation R of the polar decomposition of F: the proper rotation that maximises tr(RᵀF). It exists for inverted
/// and flat F too; where it is not unique, one of them. `guess` is a proper rotation, best the one of the last step.
/// F is finite.
Mat3 polarRotation(const Mat3& F, const Mat3& guess);

/// How many rotations polarRotations finds at a time.
inline constexpr int LANES = 4;

/// The rotations that polarRotation finds, of LANES matrices F side by side in vector registers; `R` comes with the
/// guesses and becomes the rotations.
void polarRotations(const Mat3* F, Mat3* R);

}  // namespace incision
