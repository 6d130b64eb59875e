#include "incision/pace/tool_tracker.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "incision/pace/pose_path.h"

namespace incision {
ToolTracker::ToolTracker(const ToolSettings& tool, const Edge& edge, double time_step)
    : max_step_(tool.max_step), timeout_(tool.timeout), edge_(edge), time_step_(time_step) {}

void check(const ToolTrackerMemory& memory, const MemoryLimits& limits) {
  for (const ReceivedPose& waiting : memory.waiting) {
    check(waiting.pose, limits);
    require(isRosTime(-waiting.time), "a pose's age is out of range");
  }
  if (memory.last) check(*memory.last, limits);
  require(isRosTime(memory.age), "a pose's age is out of range");
  check(memory.pose, limits);
  for (const Pose& pose : memory.way) check(pose, limits);
  check(memory.approach, limits);
}

void ToolTracker::restart(const std::optional<Pose>& at) noexcept {
  waiting_.clear();
  last_ = at;
  pose_ = at.value_or(Pose());
  active_ = true;
  last_time_ = last_call_ = 0;
  way_.clear();
  approach_.stop();
  resumed_ = stale_ = at.has_value();
}

ToolTrackerMemory ToolTracker::keep() const {
  ToolTrackerMemory memory = {waiting_, last_, active_, 0, pose_, way_, approach_, stale_};
  for (ReceivedPose& pose : memory.waiting) pose.time = std::min<Nanoseconds>(0, pose.time - last_call_);
  if (last_) memory.age = std::max<Nanoseconds>(0, last_call_ - last_time_);
  return memory;
}

void ToolTracker::recall(ToolTrackerMemory memory) noexcept {
  waiting_ = std::move(memory.waiting);
  for (ReceivedPose& pose : waiting_) pose.received = steadyNow();
  last_ = memory.last;
  active_ = memory.active;
  last_time_ = -memory.age;
  pose_ = memory.pose;
  way_ = std::move(memory.way);
  approach_ = memory.approach;
  last_call_ = 0;
  resumed_ = true;
  stale_ = memory.stale;
}

/// In a paused body no time has passed since its last step.
void ToolTracker::resume(Nanoseconds now, bool single) {
  if (!std::exchange(resumed_, false)) return;
  last_call_ = single ? now : now - static_cast<Nanoseconds>(std::llround(1e9 * time_step_));
  last_time_ += last_call_;
  for (ReceivedPose& pose : waiting_) pose.time += last_call_;
}

ToolMove ToolTracker::follow(const ToolInput& input, Nanoseconds now, bool single) {
  ToolMove move;
  resume(now, single);
  admit(input.poses, now, &move);
  bool under_way = !way_.empty();
  auto next = waiting_.begin();
  for (; next != waiting_.end() && !(under_way && beginsStroke(*next)); ++next) {
    take(*next, &move);
    under_way = true;
  }
  const bool none_taken = next == waiting_.begin(), several_taken = next - waiting_.begin() > 1;
  waiting_.erase(waiting_.begin(), next);
  const bool switches = waiting_.empty() && input.active != active_;
  if (switches && !under_way) active_ = input.active;
  if (single || several_taken || switches || !waiting_.empty()) approach_.arriveInOneStep();
  if (none_taken && !single) checkAge(now, &move);

  move.active = active_;
  if (const double share = approach_.takeShare(); share > 0) {
    move.path = simplified(pose_, takeFront(share, pose_, edge_, &way_), edge_);
    if (!move.path.empty()) pose_ = move.path.back();
  }
  last_call_ = now;
  return move;
}

void ToolTracker::admit(const std::vector<ReceivedPose>& poses, Nanoseconds now, ToolMove* move) {
  for (const ReceivedPose& pose : poses) {
    waiting_.push_back(pose);
    Nanoseconds& time = waiting_.back().time;
    time = time > 0 ? std::min(std::max(time, last_call_), now) : now;
  }
  if (poses.empty()) return;
  dropOldest();
  move->came_again = std::exchange(stale_, false);
}

/// Keeps the newest strokes; the tool is put where the first of them begins.
void ToolTracker::dropOldest() {
  int strokes = 1;
  for (auto i = waiting_.end() - 1; i != waiting_.begin(); --i) {
    const ReceivedPose& before = *(i - 1);
    if (i->active == before.active && !jumps(before.pose, i->pose)) continue;
    if (++strokes <= MAX_WAITING_STROKES) continue;
    waiting_.erase(waiting_.begin(), i);
    last_.reset();
    ++jumps_;
    return;
  }
}

bool ToolTracker::jumps(const std::optional<Pose>& from, const Pose& to) const {
  return !from || travel(*from, to, edge_) > max_step_;
}

/// Whether the pose cannot be gone to in one step with what is under way.
bool ToolTracker::beginsStroke(const ReceivedPose& pose) const {
  return pose.active != active_ || jumps(last_, pose.pose);
}

void ToolTracker::take(const ReceivedPose& pose, ToolMove* move) {
  active_ = pose.active;
  if (jumps(last_, pose.pose)) {
    if (last_) {
      ++jumps_;
      move->jump = travel(*last_, pose.pose, edge_);
    }
    move->placed = pose_ = pose.pose;
    approach_.stop();
  } else {
    way_.push_back(pose.pose);
    approach_.aim(toSeconds(pose.time - last_time_), time_step_);
  }
  last_ = pose.pose;
  last_time_ = pose.time;
  move->received = pose.received;
}

void ToolTracker::checkAge(Nanoseconds now, ToolMove* move) {
  if (!last_ || stale_ || !waiting_.empty() || toSeconds(now - last_time_) <= timeout_) return;
  stale_ = move->went_stale = true;
  way_.clear();
  approach_.stop();
  last_ = pose_;
}

}  // namespace incision
