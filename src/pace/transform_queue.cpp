#include "incision/pace/transform_queue.h"

#include <algorithm>
#include <utility>

namespace incision {
namespace {

/// Whether both are poses of one tool in one frame.
bool ofOneStream(const Command& a, const Command& b) {
  const auto* pose_a = std::get_if<ToolPose>(&a.action);
  const auto* pose_b = std::get_if<ToolPose>(&b.action);
  return pose_a != nullptr && pose_b != nullptr && pose_a->tool == pose_b->tool && a.frame == b.frame;
}

}  // namespace

TransformQueue::TransformQueue(const Frames& frames, double timeout, Release release, Refuse refuse)
    : frames_(frames), timeout_(timeout), release_(std::move(release)), refuse_(std::move(refuse)) {}

void TransformQueue::add(const Command& command) {
  const std::lock_guard<std::mutex> lock(mutex_);
  if (!overtakes(command) && tryRelease(command)) return;
  waiting_.push_back(command);
  if (waiting_.size() > MAX_WAITING_FOR_TRANSFORM) putOneOut();
}

void TransformQueue::poll(SteadyTime now) {
  const std::lock_guard<std::mutex> lock(mutex_);
  std::list<Command> due;
  due.swap(waiting_);
  try {
    while (!due.empty()) {
      const Command& command = due.front();
      const bool released = !overtakes(command) && tryRelease(command);
      if (!released && now < command.received + timeout_) {
        waiting_.splice(waiting_.end(), due, due.begin());
        continue;
      }
      if (!released) refuse_(command, {Refusal::NO_TRANSFORM, whyNot(command)});
      due.pop_front();
    }
  } catch (...) {
    waiting_.splice(waiting_.end(), due);  // of memory: they are looked at again
    throw;
  }
}

void TransformQueue::clear(const Refused& refused) {
  const std::lock_guard<std::mutex> lock(mutex_);
  for (const Command& command : waiting_) refuse_(command, refused);
  waiting_.clear();
}

bool TransformQueue::empty() const {
  const std::lock_guard<std::mutex> lock(mutex_);
  return waiting_.empty();
}

std::size_t TransformQueue::size() const {
  const std::lock_guard<std::mutex> lock(mutex_);
  return waiting_.size();
}

std::optional<Command> TransformQueue::first() const {
  const std::lock_guard<std::mutex> lock(mutex_);
  if (waiting_.empty()) return std::nullopt;
  return waiting_.front();
}

std::optional<Nanoseconds> TransformQueue::earliestStamp() const {
  const std::lock_guard<std::mutex> lock(mutex_);
  std::optional<Nanoseconds> earliest;
  for (const Command& command : waiting_)
    if (command.stamp > 0) earliest = std::min(earliest.value_or(command.stamp), command.stamp);
  return earliest;
}

/// Whether the command, released now, would come before a pose of its tool that was sent earlier.
bool TransformQueue::overtakes(const Command& command) const {
  return std::any_of(waiting_.begin(), waiting_.end(),
                     [&](const Command& earlier) { return ofOneStream(earlier, command); });
}

bool TransformQueue::tryRelease(const Command& command) {
  if (command.frame == frames_.body()) {
    release_(command);
    return true;
  }
  const auto found = frames_.find(command.frame, command.stamp, nullptr);
  if (found) release_(inBodyFrame(command, found->pose, frames_.body()));
  return found.has_value();
}

std::string TransformQueue::whyNot(const Command& command) const {
  std::string why;
  frames_.find(command.frame, command.stamp, &why);
  return "header: no transform from \"" + command.frame + "\" to \"" + frames_.body() + "\" in time: " + why;
}

void TransformQueue::putOneOut() {
  auto oldest = std::find_if(waiting_.begin(), waiting_.end(),
                             [this](const Command& command) { return !frames_.knows(command.frame); });
  if (oldest == waiting_.end()) oldest = waiting_.begin();
  refuse_(*oldest, {Refusal::TOO_MANY,
                    "too many cuts and poses wait for a transform; this one is given in \"" + oldest->frame + "\""});
  waiting_.erase(oldest);
}

}  // namespace incision
