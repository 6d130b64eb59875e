#pragma once

#include "support/rig.h"

namespace incision::report {

/// How well a step solves its equation
///   (M + Δt C + Δt² K) Δv = Δt (f_ext − C v − f_int − Δt K v),  C = α M + β K,
/// in norms scaled by the diagonal of the matrix on the left.
struct StepResidual {
  /// ‖right − left‖ / ‖right‖ of the body as a whole.
  double relative = 0;
  /// The worst piece's ‖right − left‖ as a share of what is asked: the tolerance times ‖right‖ (of a piece at rest: of
  /// the whole body, by its share of the mass), and what rounding of the positions does to its forces.
  double share = 0;
};

/// Reckons it in long double, part by part, from the parts' shares and centroids alone: gradients, rotations (by a
/// singular value decomposition), stiffness and mass are its own. For lumped mass, and gravity alone. The step has led
/// from `before` to where the rig is now.
StepResidual stepResidual(const Rig& rig, const RigSettings& settings, const Motion& before, double tolerance);

}  // namespace incision::report
