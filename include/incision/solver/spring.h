#pragma once

#include <array>
#include <cassert>
#include <vector>

#include "incision/mesh/tet_mesh.h"
#include "incision/rigid/wrench.h"

namespace incision {

/// Δt² k over the mass that resists where springs act, for those that only stand for what is stiff. Beyond that they
/// act as if they were rigid, and only make the step hard to settle: with 10 a piece that lies on the ground sinks in
/// by a few hundredths of g Δt². (Castro et al., "An unconstrained convex formulation of compliant contact", bound it
/// likewise, by 40.)
inline constexpr double STIFFEST = 10;

/// A spring between copies, or between copies and something outside. It acts on y = Σ_i weights[i] x_i; each copy feels
/// weights[i] of its force. At the displacement of y in the step, the rigid motion of pieces included, its force on y
/// at the step's end is F − K Δy: there, and near it as far as the spring is linear.
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

  /// The force on y [N] at a displacement of y [m].
  Vec3 at(const Vec3& moved) const { return force - stiffness * moved; }

  /// Takes a stiffness, and the force that there is at a displacement.
  void set(const Mat3& K, const Vec3& force_there, const Vec3& moved) {
    stiffness = K;
    force = force_there + K * moved;
  }

  /// Whether the spring adds to the matrix.
  bool isStiff() const { return !stiffness.isZero(0); }
};

/// Σ_i weights[i] values[copies[i]]: y of the positions, Δy of the displacements.
inline Vec3 weightedSum(const Spring& spring, const std::vector<Vec3>& values) {
  Vec3 sum = Vec3::Zero();
  for (int i = 0; i < spring.count; ++i) sum += spring.weights[i] * values[spring.copies[i]];
  return sum;
}

/// Adds to each copy its share of what acts on y.
inline void addShares(const Spring& spring, const Vec3& on_y, std::vector<Vec3>* sums) {
  for (int i = 0; i < spring.count; ++i) (*sums)[spring.copies[i]] += spring.weights[i] * on_y;
}

/// What the body does to the spring's other end, about the origin of the body's frame: against `force` [N] on y, which
/// is the mean over a step. By the lever `y` [m] it changes Σ x × m v of the body.
Wrench wrenchOf(const Vec3& force, const Vec3& y);

}  // namespace incision
