#pragma once

#include <deque>
#include <mutex>
#include <optional>
#include <vector>

#include "incision/pace/command.h"

namespace incision {

/// Most cuts that may wait for their step: more than anyone plans ahead, and little memory.
inline constexpr std::size_t MAX_WAITING_CUTS = 1000;

/// Most tool poses kept between two steps: ten thousand a second in steps of a tenth of one. A longer path is thinned
/// evenly, and still follows any that a hand can take in that time.
inline constexpr std::size_t MAX_WAITING_POSES = 1024;

/// A pose of the tool's link in the body's frame, as it came.
struct ReceivedPose {
  Pose pose;
  Nanoseconds time;  ///< of receipt on the steady clock; with use_sim_time the stamp, so that a bag replays exactly
  SteadyTime received;
  bool active = true;  ///< the blade is on on the way there
};

/// What is asked of the tool before a step.
struct ToolInput {
  std::vector<ReceivedPose> poses;
  bool active = true;  ///< the blade is on after them
};

/// Commands in the body's frame that wait for the step before which they take effect, ordered by stamp and then by
/// arrival. Filled by the thread of the commands, emptied by the one that takes the steps.
class Agenda {
 public:
  /// When the agenda is full, the cut with the latest stamp is put out and returned.
  std::optional<PlaneCut> add(const PlaneCut& plane, Nanoseconds stamp);
  /// The agenda knows whether the blade is on.
  void add(const ReceivedPose& pose, Nanoseconds stamp);

  /// Switches the blade on, as it is at first, or off, after the pose that was added last.
  void activate(bool active);

  /// What is stamped up to `time`, in order.
  std::vector<PlaneCut> takeCuts(Nanoseconds time);
  ToolInput takeTool(Nanoseconds time);

  /// Empties the agenda and switches the blade on; returns the cuts that will not be made.
  std::vector<PlaneCut> clear();

  /// Commands so far that arrived after their stamp had been passed, and poses left out.
  std::uint64_t late() const;
  std::uint64_t thinned() const;

 private:
  template <class T>
  struct Entry {
    Nanoseconds stamp;
    std::int64_t arrival;  ///< counts up
    T action;
  };
  template <class T>
  void insert(std::deque<Entry<T>>& entries, const T& action, Nanoseconds stamp);
  void thinPoses();
  template <class T>
  std::vector<T> take(std::deque<Entry<T>>& entries, Nanoseconds time);

  mutable std::mutex mutex_;
  std::deque<Entry<PlaneCut>> cuts_;
  std::deque<Entry<ReceivedPose>> poses_;
  std::int64_t arrivals_ = 0;
  Nanoseconds taken_ = 0;
  std::uint64_t late_ = 0, thinned_ = 0;

  // The blade is switched after the pose of that stamp. What it was switched to before that, the poses say.
  bool active_ = true, active_taken_ = true;
  Nanoseconds last_pose_ = 0, switched_after_ = 0;
};

}  // namespace incision
