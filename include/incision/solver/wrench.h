#pragma once

#include <vector>

#include "incision/solver/coupling.h"

namespace incision {

/// A force and what it turns about a point, in axes that go with it.
struct Wrench {
  Vec3 force = Vec3::Zero();   ///< [N]
  Vec3 torque = Vec3::Zero();  ///< [N m]
};

/// (1 − s) a + s b, both about one point.
Wrench between(const Wrench& a, const Wrench& b, double s);

/// What the body does to the tool, on the mean of a step of `time_step` [s]: against the forces of the couplings marked
/// so, about the origin of the body's frame. Each acts where its copies are at the step's start, at `x` [m]: by that
/// lever it changes Σ x × m v from the step's start to its end. `v_end` are the velocities at the end [m/s].
Wrench toolWrench(const std::vector<Coupling>& couplings, double time_step, const std::vector<Vec3>& x,
                  const std::vector<Vec3>& v_end);

}  // namespace incision
