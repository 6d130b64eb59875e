#pragma once

#include <optional>
#include <vector>

#include "incision/pace/approach.h"
#include "incision/pace/tool_queue.h"

namespace incision {

/// Turns the angles that a tool's jaw is told to go to into where it is in each step: to the newest, evenly in the time
/// since the one before it. Used by the stepping thread.
class JawTracker {
 public:
  /// `time_step` [s].
  explicit JawTracker(double time_step) : time_step_(time_step) {}

  /// Where the jaw goes in the next step, if it moves [rad]. In a `single` step, of a paused body, it goes all the way.
  std::optional<double> follow(const std::vector<ReceivedAngle>& angles, bool single);

  /// Nothing is known of the jaw any more: it is where the body has it, until it is told to go somewhere.
  void restart();

 private:
  const double time_step_;
  std::optional<double> target_;
  double angle_ = 0;  ///< after the step asked for last
  Nanoseconds last_time_ = 0;
  Approach approach_;
};

}  // namespace incision
