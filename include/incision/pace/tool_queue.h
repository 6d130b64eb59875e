#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

#include "incision/pace/stamped_queue.h"

namespace incision {

/// Most poses of a tool kept between two steps: ten thousand a second in steps of a tenth of one. A longer path is
/// thinned evenly, and still follows any that a hand can take in that time.
inline constexpr std::size_t MAX_WAITING_POSES = 1024;

/// A pose of a tool's link in the body's frame, as it came.
struct ReceivedPose {
  Pose pose;
  Nanoseconds time;  ///< of receipt on the steady clock; with use_sim_time the stamp, so that a bag replays exactly
  SteadyTime received;
  bool active = true;  ///< the blade is on on the way there
};

/// An angle of a tool's jaw [rad], with its times like those of a pose.
struct ReceivedAngle {
  double angle;
  Nanoseconds time;
  SteadyTime received = {};
};

/// When something came, and for when.
struct Arrival {
  Nanoseconds stamp;
  SteadyTime received;
};

/// What is asked of a tool before a step.
struct ToolInput {
  std::vector<ReceivedPose> poses;
  bool active = true;  ///< the blade is on after them
  std::vector<ReceivedAngle> jaw = {};
};

/// What is asked of one tool, by stamp. Knows whether its blade is on.
class ToolQueue {
 public:
  /// `pose.active` is filled in here.
  void add(ReceivedPose pose, Nanoseconds stamp);

  void add(const ReceivedAngle& angle, Nanoseconds stamp);

  /// Switches the blade on, as it is at first, or off, after the pose that was added last.
  void activate(bool active);

  /// What is stamped up to `time`.
  ToolInput take(Nanoseconds time);

  /// Forgets all but the count of poses left out, and whether the blade is on.
  void clear(bool active) noexcept;

  /// Poses and angles that wait; of those stamped later than `time` when the first one came.
  std::size_t size() const { return poses_.size() + jaw_.size(); }
  std::optional<Arrival> firstAfter(Nanoseconds time) const;

  /// Poses and angles left out, so far.
  std::uint64_t thinned() const { return thinned_; }

 private:
  template <class Value>
  void thinWhereFull(StampedQueue<Value>* queue);

  StampedQueue<ReceivedPose> poses_;
  StampedQueue<ReceivedAngle> jaw_;
  std::uint64_t thinned_ = 0;

  // The blade is switched after the pose of that stamp. Whether it was on before, the poses say.
  bool active_ = true, active_taken_ = true;
  Nanoseconds last_pose_ = 0, switched_after_ = 0;
};

}  // namespace incision
