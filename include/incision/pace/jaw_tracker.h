#pragma once

#include <optional>
#include <vector>

#include "incision/pace/approach.h"
#include "incision/pace/tool_queue.h"

namespace incision {

/// What of a JawTracker outlasts a step.
struct JawTrackerMemory {
  std::optional<double> target;  ///< [rad]
  double angle = 0;              ///< after the step asked for last [rad]
  Nanoseconds age = 0;           ///< of the target, at the step asked for last
  Approach approach;
};

template <class Archive>
void serialize(Archive& archive, JawTrackerMemory& memory) {
  auto& [target, angle, age, approach] = memory;
  archive(target, angle, age, approach);
}

void check(const JawTrackerMemory& memory, const MemoryLimits& limits);

/// Turns the angles that a tool's jaw is told to go to into where it is in each step: to the newest, evenly in the time
/// since the one before it. Used by the stepping thread.
class JawTracker {
 public:
  /// `time_step` [s].
  explicit JawTracker(double time_step) : time_step_(time_step) {}

  /// Where the jaw goes in the next step, if it moves [rad]. `now` is a time like those of the angles. In a `single`
  /// step, of a paused body, it goes all the way.
  std::optional<double> follow(const std::vector<ReceivedAngle>& angles, Nanoseconds now, bool single);

  /// Nothing is known of the jaw any more: it is where the body has it, until it is told to go somewhere.
  void restart() noexcept;

  /// Goes on as if no time had passed since the step before keep(): its target is as old as then.
  JawTrackerMemory keep() const;
  void recall(const JawTrackerMemory& memory) noexcept;

 private:
  void resume(Nanoseconds now, bool single);

  const double time_step_;
  std::optional<double> target_;
  double angle_ = 0;  ///< after the step asked for last
  Nanoseconds last_time_ = 0, last_call_ = 0;
  bool resumed_ = false;  ///< times are less the last call's, which is still to be known
  Approach approach_;
};

}  // namespace incision
