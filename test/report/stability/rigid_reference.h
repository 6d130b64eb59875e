#pragma once

#include <Eigen/Core>
#include <vector>

#include "support/rig.h"

namespace incision::report {

/// In long double.
using Real = long double;
using RealVec = Eigen::Matrix<Real, 3, 1>;
using RealMat = Eigen::Matrix<Real, 3, 3>;

/// What a step starts from, by copy.
struct ReferenceBase {
  std::vector<RealVec> x, v, u;  ///< x̂ [m], v̂ and u [m/s]
  /// What a rounding of all moments of inertia of its piece moves it by, over that rounding [m]: about the axis of the
  /// least one, of which a needle has few digits.
  std::vector<Real> turned;
};

/// That of the rigid motion of free pieces over a step of the rig: by the sums over each piece of lumped masses [kg]. A
/// turn ω Δt of more than 0.3 rad is made of turns of 0.05 rad at most, by the largest rate that its spin might have.
ReferenceBase rigidReference(const Rig& rig, const Motion& start, const std::vector<Real>& mass);

}  // namespace incision::report
