#pragma once

#include "support/rig.h"

namespace incision::report {

/// How well a step of implicit Euler solves its equation,
///   (M + Δt C + Δt² K) Δv = Δt (f_ext − α M (v̂ + u) − β K u − f_int(x̂) − Δt K u),  C = α M + β K,
/// where x̂, v̂ and u are those of the exact rigid motion of free pieces (x, 0 and v of the others), with the rotations
/// at x̂, and Δv = v − v̂ − u of the velocities v at its end. In norms scaled by the diagonal of the matrix on the left.
struct StepResidual {
  /// ‖right − left‖ over ‖right‖, or over ‖Δt f_ext‖ where that is larger, of the body as a whole.
  double relative = 0;
  /// The worst piece's ‖right − left‖ as a share of what is asked: the tolerance times the larger of ‖right‖ and
  /// ‖Δt f_ext‖ (of a piece on which little acts: of the whole body, by its share of the mass), and what rounding of
  /// the positions does to its forces.
  double share = 0;
  /// How far the worst copy is from x̂ + Δt (v − v̂), as a share of what rounding of its place may do.
  double off_place = 0;
};

/// Reckons it in long double, part by part, from the parts' shares and centroids alone: gradients, rotations (by a
/// singular value decomposition), rigid motion, stiffness and mass are its own. For lumped mass, gravity alone, and
/// steps in which nothing is coupled. The step has led from `before` to where the rig is now.
StepResidual stepResidual(const Rig& rig, const RigSettings& settings, const Motion& before, double tolerance);

}  // namespace incision::report
