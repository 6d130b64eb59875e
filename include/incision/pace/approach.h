#pragma once

#include <algorithm>
#include <cmath>

#include "incision/base/memory_limits.h"

namespace incision {

/// Poses that come more seldom than steps are followed evenly, each in the time since the one before it and this [s] at
/// most: a publisher at 10 Hz still looks smooth, and one that pauses is not followed late.
inline constexpr double MAX_POSE_PERIOD = 0.1;

/// The steps over which something goes evenly to where it was last told to be.
class Approach {
 public:
  /// There is a new target, known `period` [s] after the one before it.
  void aim(double period, double time_step) {
    steps_left_ = std::max(1, static_cast<int>(std::lround(std::min(period, MAX_POSE_PERIOD) / time_step)));
  }
  /// What is still to go is gone in the next step, if anything is.
  void arriveInOneStep() { steps_left_ = std::min(steps_left_, 1); }
  /// It stays where it is.
  void stop() { steps_left_ = 0; }

  int stepsLeft() const { return steps_left_; }

  /// The next step's share of what is still to go; 0: there is none.
  double takeShare() { return steps_left_ > 0 ? 1.0 / steps_left_-- : 0; }

 private:
  template <class Archive>
  friend void serialize(Archive& archive, Approach& approach) {
    archive(approach.steps_left_);
  }

  int steps_left_ = 0;
};

inline void check(const Approach& approach, const MemoryLimits& /*limits*/) {
  require(approach.stepsLeft() >= 0, "something arrives before it has gone");
}

}  // namespace incision
