#include "incision/pace/tool_queue.h"

namespace incision {

template <class Value>
void ToolQueue::thinWhereFull(StampedQueue<Value>* queue) {
  if (queue->size() <= MAX_WAITING_POSES) return;
  queue->thin();
  ++thinned_;
}

void ToolQueue::add(ReceivedPose pose, Nanoseconds stamp) {
  pose.active = active_;
  poses_.add(pose, stamp);
  last_pose_ = stamp;
  thinWhereFull(&poses_);
}

void ToolQueue::add(const ReceivedAngle& angle, Nanoseconds stamp) {
  jaw_.add(angle, stamp);
  thinWhereFull(&jaw_);
}

void ToolQueue::activate(bool active) {
  active_ = active;
  switched_after_ = last_pose_;
}

ToolInput ToolQueue::take(Nanoseconds time) {
  ToolInput input;
  input.poses = poses_.take(time);
  input.jaw = jaw_.take(time);
  if (!input.poses.empty()) active_taken_ = input.poses.back().active;
  if (switched_after_ <= time) active_taken_ = active_;
  input.active = active_taken_;
  return input;
}

std::optional<Arrival> ToolQueue::firstAfter(Nanoseconds time) const {
  std::optional<Arrival> first;
  const auto offer = [&](const auto* entry) {
    if (entry != nullptr && (!first || entry->thing.received < first->received))
      first = Arrival{entry->stamp, entry->thing.received};
  };
  offer(poses_.firstAfter(time));
  offer(jaw_.firstAfter(time));
  return first;
}

void ToolQueue::clear(bool active) noexcept {
  poses_.clear();
  jaw_.clear();
  active_ = active_taken_ = active;
  last_pose_ = switched_after_ = 0;
}

}  // namespace incision
