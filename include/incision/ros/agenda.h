#pragma once

#include <deque>
#include <mutex>
#include <optional>
#include <vector>

#include "incision/ros/command.h"

namespace incision {

/// Most cuts that may wait for their step: more than anyone plans ahead, and little memory.
inline constexpr std::size_t MAX_WAITING_CUTS = 1000;

/// Most tool poses kept between two steps. A longer path is thinned evenly: 256 poses still follow any path a hand can
/// take in the time of one step.
inline constexpr std::size_t MAX_WAITING_POSES = 256;

/// Commands in the body's frame that wait for the step before which they take effect, ordered by stamp and then by
/// arrival. Filled by the thread of the commands, emptied by the one that takes the steps.
class Agenda {
 public:
  /// When the agenda is full, the cut with the latest stamp is put out and returned.
  std::optional<PlaneCut> add(const PlaneCut& plane, Nanoseconds stamp);
  void add(const Pose& pose, Nanoseconds stamp);

  /// What is stamped up to `time`, in order.
  std::vector<PlaneCut> takeCuts(Nanoseconds time);
  std::vector<Pose> takePoses(Nanoseconds time);

  /// Empties the agenda; returns the cuts that will not be made.
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
  std::deque<Entry<Pose>> poses_;
  std::int64_t arrivals_ = 0;
  Nanoseconds taken_ = 0;
  std::uint64_t late_ = 0, thinned_ = 0;
};

}  // namespace incision
