#include "incision/pace/jaw_tracker.h"

namespace incision {

std::optional<double> JawTracker::follow(const std::vector<ReceivedAngle>& angles, bool single) {
  if (!angles.empty()) {
    const ReceivedAngle& newest = angles.back();
    approach_.aim(1e-9 * static_cast<double>(newest.time - last_time_), time_step_);
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

void JawTracker::restart() {
  target_.reset();
  last_time_ = 0;
  approach_.stop();
}

}  // namespace incision
