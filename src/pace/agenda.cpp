#include "incision/pace/agenda.h"

#include <utility>

namespace incision {
void Agenda::countIfLate(Nanoseconds stamp) {
  if (stamp > 0 && stamp <= taken_) ++late_;
}

void Agenda::noteTaken(Nanoseconds time) {
  if (time > 0) taken_ = time;
}

std::optional<PlaneCut> Agenda::add(const PlaneCut& plane, Nanoseconds stamp, SteadyTime received) {
  const std::lock_guard<std::mutex> lock(mutex_);
  countIfLate(stamp);
  cuts_.add({plane, stamp, received}, stamp);
  if (cuts_.size() <= MAX_WAITING_CUTS) return std::nullopt;
  return cuts_.takeLast().plane;
}

void Agenda::add(int tool, const ReceivedPose& pose, Nanoseconds stamp) {
  const std::lock_guard<std::mutex> lock(mutex_);
  countIfLate(stamp);
  at(tool).add(pose, stamp);
}

void Agenda::add(int tool, const ReceivedAngle& angle, Nanoseconds stamp) {
  const std::lock_guard<std::mutex> lock(mutex_);
  countIfLate(stamp);
  at(tool).add(angle, stamp);
}

void Agenda::activate(int tool, bool active) {
  const std::lock_guard<std::mutex> lock(mutex_);
  at(tool).activate(active);
}

std::vector<WaitingCut> Agenda::takeCuts(Nanoseconds time) {
  const std::lock_guard<std::mutex> lock(mutex_);
  noteTaken(time);
  return cuts_.take(time);
}

ToolInput Agenda::takeTool(int tool, Nanoseconds time) {
  const std::lock_guard<std::mutex> lock(mutex_);
  noteTaken(time);
  return at(tool).take(time);
}

void Agenda::clearTools(const IsActive& isActive) noexcept {
  const std::lock_guard<std::mutex> lock(mutex_);
  for (std::size_t i = 0; i < tools_.size(); ++i) tools_[i].clear(!isActive || isActive(i));
  taken_ = 0;
}

std::optional<WaitingCut> Agenda::takeCut() noexcept {
  const std::lock_guard<std::mutex> lock(mutex_);
  if (cuts_.size() == 0) return std::nullopt;
  return cuts_.takeNext();
}

std::size_t Agenda::size() const {
  const std::lock_guard<std::mutex> lock(mutex_);
  std::size_t sum = cuts_.size();
  for (const ToolQueue& tool : tools_) sum += tool.size();
  return sum;
}

std::optional<WaitingCut> Agenda::firstCutAfter(Nanoseconds time) const {
  const std::lock_guard<std::mutex> lock(mutex_);
  const auto* first = cuts_.firstAfter(time);
  if (first == nullptr) return std::nullopt;
  return first->thing;
}

std::optional<Arrival> Agenda::firstOfToolAfter(int tool, Nanoseconds time) const {
  const std::lock_guard<std::mutex> lock(mutex_);
  return at(tool).firstAfter(time);
}

std::uint64_t Agenda::late() const {
  const std::lock_guard<std::mutex> lock(mutex_);
  return late_;
}

std::uint64_t Agenda::thinned() const {
  const std::lock_guard<std::mutex> lock(mutex_);
  std::uint64_t sum = 0;
  for (const ToolQueue& tool : tools_) sum += tool.thinned();
  return sum;
}

std::uint64_t Agenda::thinned(int tool) const {
  const std::lock_guard<std::mutex> lock(mutex_);
  return tools_.at(static_cast<std::size_t>(tool)).thinned();
}

}  // namespace incision
