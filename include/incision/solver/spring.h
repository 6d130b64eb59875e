#pragma once

#include <array>
#include <cassert>
#include <vector>

#include "incision/mesh/tet_mesh.h"
#include "incision/rigid/wrench.h"

namespace incision {

/// A linear spring between copies, or between copies and something outside. With y = Σ_i weights[i] x_i the
/// force F − K Δt ẏ acts on y at the end of a step, ẏ being of the velocities there; each copy feels weights[i] of it.
struct Spring {
  std::array<int, 8> copies;  ///< the first `count` of them, each once
  std::array<double, 8> weights;
  int count = 0;
  Mat3 stiffness = Mat3::Zero();  ///< K [N/m], symmetric, positive semidefinite
  Vec3 force = Vec3::Zero();      ///< F [N], what it would be if nothing moved in the step
  int coupler = 0;                ///< index of the one that it belongs to

  /// Adds to the weight of a copy. There is room for those of two parts.
  void add(int copy, double weight) {
    int i = 0;
    while (i < count && copies[i] != copy) ++i;
    assert(i < static_cast<int>(copies.size()));
    if (i == count) weights[count++] = 0;
    copies[i] = copy;
    weights[i] += weight;
  }
};

/// Σ_i weights[i] values[copies[i]]: y of the positions, ẏ of the velocities.
inline Vec3 weightedSum(const Spring& spring, const std::vector<Vec3>& values) {
  Vec3 sum = Vec3::Zero();
  for (int i = 0; i < spring.count; ++i) sum += spring.weights[i] * values[spring.copies[i]];
  return sum;
}

/// Δt times the force on y [N s], for the velocities `v_end` at the end of the step.
Vec3 impulseOf(const Spring& spring, double time_step, const std::vector<Vec3>& v_end);

/// Adds Δt times the forces [N s] of the springs at the velocities `v_end` at the end of the step.
void addImpulses(const std::vector<Spring>& springs, double time_step, const std::vector<Vec3>& v_end,
                 std::vector<Vec3>* impulses);

/// What the body does to the spring's other end, on the mean of a step of `time_step` [s]: against the spring's force,
/// about the origin of the body's frame. It acts where the copies are at the step's start, at `x` [m]: by that lever it
/// changes Σ x × m v from the step's start to its end. `v_end` are the velocities at the end [m/s].
Wrench wrenchOf(const Spring& spring, double time_step, const std::vector<Vec3>& x, const std::vector<Vec3>& v_end);

}  // namespace incision
