#include "incision/ros/transform_queue.h"

#include <algorithm>

#include "incision/ros/conversions.h"

namespace incision {
namespace {

bool isPose(const Command& command) { return std::holds_alternative<Pose>(command.action); }

Command inBodyFrame(Command command, const std::string& body_frame, const Eigen::Isometry3d& to_body) {
  std::visit([&](auto& action) { action = transformed(action, to_body); }, command.action);
  command.frame = body_frame;
  return command;
}

}  // namespace

TransformQueue::TransformQueue(const tf2::BufferCore& buffer, std::string body_frame, double timeout, Release release,
                               Refuse refuse)
    : buffer_(buffer),
      body_frame_(std::move(body_frame)),
      timeout_(timeout),
      release_(std::move(release)),
      refuse_(std::move(refuse)) {}

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
  for (const Command& command : due) {
    if (!overtakes(command) && tryRelease(command)) continue;
    if (now < command.received + timeout_)
      waiting_.push_back(command);
    else
      refuse_(command, {Refusal::NO_TRANSFORM, whyNot(command)});
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

std::optional<Nanoseconds> TransformQueue::earliestStamp() const {
  const std::lock_guard<std::mutex> lock(mutex_);
  std::optional<Nanoseconds> earliest;
  for (const Command& command : waiting_)
    if (command.stamp > 0) earliest = std::min(earliest.value_or(command.stamp), command.stamp);
  return earliest;
}

/// Released now, the pose would come before one that was sent earlier.
bool TransformQueue::overtakes(const Command& command) const {
  return isPose(command) && std::any_of(waiting_.begin(), waiting_.end(), [&](const Command& earlier) {
           return isPose(earlier) && earlier.frame == command.frame;
         });
}

bool TransformQueue::tryRelease(const Command& command) {
  if (command.frame == body_frame_) {
    release_(command);
    return true;
  }
  try {
    if (!buffer_.canTransform(body_frame_, command.frame, toRos(command.stamp))) return false;
    const auto transform = buffer_.lookupTransform(body_frame_, command.frame, toRos(command.stamp)).transform;
    release_(inBodyFrame(command, body_frame_, toIsometry(transform)));
    return true;
  } catch (const std::exception&) {  // also of ros::Time, when a stamp is too far off to subtract
    return false;
  }
}

std::string TransformQueue::whyNot(const Command& command) const {
  std::string why;
  try {
    buffer_.canTransform(body_frame_, command.frame, toRos(command.stamp), &why);
  } catch (const std::exception& error) {
    why = error.what();
  }
  return "header: no transform from \"" + command.frame + "\" to \"" + body_frame_ + "\" in time: " + why;
}

void TransformQueue::putOneOut() {
  auto oldest = std::find_if(waiting_.begin(), waiting_.end(),
                             [this](const Command& command) { return !buffer_._frameExists(command.frame); });
  if (oldest == waiting_.end()) oldest = waiting_.begin();
  refuse_(*oldest,
          {Refusal::TOO_MANY, "too many commands wait for a transform; this one from \"" + oldest->frame + "\""});
  waiting_.erase(oldest);
}

}  // namespace incision
