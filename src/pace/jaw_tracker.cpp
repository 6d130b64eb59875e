#include "incision/pace/jaw_tracker.h"

#include <cmath>
#include <cstdlib>
#include <utility>

namespace incision {

void check(const JawTrackerMemory& memory, const MemoryLimits& limits) {
  require(isRosTime(std::abs(memory.age)), "a jaw's age is out of range");
  require(memory.target || memory.approach.stepsLeft() == 0, "a jaw goes to no angle");
  check(memory.approach, limits);
}

void JawTracker::restart() noexcept { recall(JawTrackerMemory()); }

JawTrackerMemory JawTracker::keep() const {
  return {target_, angle_, target_ ? last_call_ - last_time_ : 0, approach_};
}

void JawTracker::recall(const JawTrackerMemory& memory) noexcept {
  target_ = memory.target;
  angle_ = memory.angle;
  last_time_ = -memory.age;
  last_call_ = 0;
  resumed_ = target_.has_value();
  approach_ = memory.approach;
}

/// In a paused body no time has passed since its last step.
void JawTracker::resume(Nanoseconds now, bool single) {
  if (!std::exchange(resumed_, false)) return;
  last_time_ += single ? now : now - static_cast<Nanoseconds>(std::llround(1e9 * time_step_));
}

std::optional<double> JawTracker::follow(const std::vector<ReceivedAngle>& angles, Nanoseconds now, bool single) {
  resume(now, single);
  last_call_ = now;
  if (!angles.empty()) {
    const ReceivedAngle& newest = angles.back();
    approach_.aim(toSeconds(newest.time - last_time_), time_step_);
    if (!target_) approach_.arriveInOneStep();
    target_ = newest.angle;
    last_time_ = newest.time;
  }
  if (single) approach_.arriveInOneStep();
  const double share = approach_.takeShare();
  if (share == 0) return std::nullopt;
  angle_ = share == 1 ? *target_ : angle_ + share * (*target_ - angle_);
  return angle_;
}

}  // namespace incision
