#include "incision/pace/agenda.h"

#include <algorithm>

namespace incision {

template <class T>
void Agenda::insert(std::deque<Entry<T>>& entries, const T& action, Nanoseconds stamp) {
  if (stamp > 0 && stamp <= taken_) ++late_;
  const auto place = std::upper_bound(entries.begin(), entries.end(), stamp,
                                      [](Nanoseconds time, const Entry<T>& entry) { return time < entry.stamp; });
  entries.insert(place, {stamp, arrivals_++, action});
}

template <class T>
std::vector<T> Agenda::take(std::deque<Entry<T>>& entries, Nanoseconds time) {
  if (time > 0) taken_ = time;
  std::vector<T> taken;
  while (!entries.empty() && entries.front().stamp <= time) {
    taken.push_back(std::move(entries.front().action));
    entries.pop_front();
  }
  return taken;
}

std::optional<PlaneCut> Agenda::add(const PlaneCut& plane, Nanoseconds stamp) {
  const std::lock_guard<std::mutex> lock(mutex_);
  insert(cuts_, plane, stamp);
  if (cuts_.size() <= MAX_WAITING_CUTS) return std::nullopt;
  PlaneCut last = std::move(cuts_.back().action);
  cuts_.pop_back();
  return last;
}

void Agenda::add(const ReceivedPose& pose, Nanoseconds stamp) {
  const std::lock_guard<std::mutex> lock(mutex_);
  insert(poses_, {pose.pose, pose.time, pose.received, active_}, stamp);
  last_pose_ = stamp;
  if (poses_.size() > MAX_WAITING_POSES) thinPoses();
}

/// Leaves out the pose that is missed least: the one with the closest neighbours, by arrival. Both ends stay.
void Agenda::thinPoses() {
  std::size_t closest = 1;
  const auto gap = [this](std::size_t i) { return poses_[i + 1].arrival - poses_[i - 1].arrival; };
  for (std::size_t i = 2; i + 1 < poses_.size(); ++i)
    if (gap(i) < gap(closest)) closest = i;
  poses_.erase(poses_.begin() + static_cast<std::ptrdiff_t>(closest));
  ++thinned_;
}

std::vector<PlaneCut> Agenda::takeCuts(Nanoseconds time) {
  const std::lock_guard<std::mutex> lock(mutex_);
  return take(cuts_, time);
}

void Agenda::activate(bool active) {
  const std::lock_guard<std::mutex> lock(mutex_);
  active_ = active;
  switched_after_ = last_pose_;
}

ToolInput Agenda::takeTool(Nanoseconds time) {
  const std::lock_guard<std::mutex> lock(mutex_);
  ToolInput input;
  input.poses = take(poses_, time);
  if (!input.poses.empty()) active_taken_ = input.poses.back().active;
  if (switched_after_ <= time) active_taken_ = active_;
  input.active = active_taken_;
  return input;
}

std::vector<PlaneCut> Agenda::clear() {
  const std::lock_guard<std::mutex> lock(mutex_);
  std::vector<PlaneCut> cuts;
  for (Entry<PlaneCut>& entry : cuts_) cuts.push_back(std::move(entry.action));
  cuts_.clear();
  poses_.clear();
  taken_ = last_pose_ = switched_after_ = 0;
  active_ = active_taken_ = true;
  return cuts;
}

std::uint64_t Agenda::late() const {
  const std::lock_guard<std::mutex> lock(mutex_);
  return late_;
}

std::uint64_t Agenda::thinned() const {
  const std::lock_guard<std::mutex> lock(mutex_);
  return thinned_;
}

}  // namespace incision
