#include "incision/pace/step_input.h"

#include <cmath>
#include <sstream>
#include <utility>

namespace incision {

StepInput::StepInput(DeformableBody& body, Pacer& pacer, Commands& commands, const Frames& frames, Answers& answers)
    : body_(body),
      pacer_(pacer),
      commands_(commands),
      answers_(answers),
      obstacles_(LinkLookup(frames, warnOfLinks("the obstacles", answers)), linksOf(body.obstacles()),
                 body.scene().solver.time_step),
      clamps_(frames, warnOfLinks("the clamps", answers), body.scene().boundary, body.scene().solver.time_step) {
  for (std::size_t i = 0; i < body.tools(); ++i)
    tools_.emplace_back(i, body.scene(), body.toolForm(i), frames, answers);
}

StepInput::Due StepInput::update(SteadyTime now) {
  pacer_.update(now);
  Due due;
  due.step = stepDue();
  due.cut = applyCuts(due.step);
  return due;
}

/// Where commands take effect at once, no step needs to wait for one.
bool StepInput::stepDue() const {
  if (paused_ || !pacer_.due()) return false;
  return !pacer_.goesByStamps() || pacer_.lag() >= MAX_DELAY || !commands_.waitsFor(pacer_.nextStart());
}

/// Stamped commands are taken together when their step is due, since they may arrive in another order.
bool StepInput::applyCuts(bool step_due) {
  const Nanoseconds time = paused_ ? pacer_.clock() : step_due ? pacer_.nextStart() : 0;
  const std::vector<WaitingCut> cuts = commands_.takeCuts(time);
  for (const WaitingCut& cut : cuts) {
    CutResult result;
    try {
      result = body_.cut(cut.plane);
    } catch (const std::exception& error) {
      answers_.refuseCut(cut.plane.label, {Refusal::BY_BODY, error.what()});
      continue;
    }
    answers_.report(result);
  }
  return !cuts.empty();
}

StepTime StepInput::stepTime(SteadyTime now) const {
  if (!pacer_.goesByStamps())
    return {std::chrono::nanoseconds(now.time_since_epoch()).count(), 0,
            std::chrono::nanoseconds(std::chrono::system_clock::now().time_since_epoch()).count(), paused_};
  const auto time_step = static_cast<Nanoseconds>(std::llround(1e9 * body_.scene().solver.time_step));
  const Nanoseconds start = paused_ ? pacer_.clock() : pacer_.nextStart();
  return {start, pacer_.nextStart() + time_step, start, paused_};
}

/// Poses stamped later than the step's start wait.
void StepInput::lead(SteadyTime now) {
  const StepTime time = stepTime(now);
  const Nanoseconds start = paused_ ? pacer_.clock() : pacer_.nextStart();
  for (std::size_t i = 0; i < tools_.size(); ++i)
    tools_[i].lead(commands_.takeTool(static_cast<int>(i), start), time, &body_);
  moveObstacles(time);
  moveClamps(time);
}

/// The obstacles' links go where tf has them at the step's end.
void StepInput::moveObstacles(const StepTime& time) {
  for (const LinkMove& move : obstacles_.follow(time.ros, time.end)) {
    if (move.jump_speed)
      warnOfJump("link \"" + body_.obstacles().links[static_cast<std::size_t>(move.link)].name + "\" of the obstacles",
                 *move.jump_speed, "");
    if (move.at_once)
      body_.placeObstacle(move.link, move.pose);
    else
      body_.moveObstacle(move.link, move.pose);
  }
}

/// The clamps' frames go where tf has them at the step's end.
void StepInput::moveClamps(const StepTime& time) {
  for (const LinkMove& move : clamps_.follow(time.ros, time.end, time.single)) {
    if (move.jump_speed)
      warnOfJump("frame \"" + body_.scene().boundary[static_cast<std::size_t>(move.link)].frame + "\" of a clamp",
                 *move.jump_speed, ": the clamp is put there at once");
    if (move.at_once)
      body_.placeClamp(move.link, move.pose);
    else
      body_.moveClamp(move.link, move.pose);
  }
}

void StepInput::warnOfJump(const std::string& what, double speed, const std::string& then) {
  std::ostringstream text;
  text << what << " jumped, at " << speed << " m/s (followed: up to " << MAX_OBSTACLE_SPEED << " m/s)" << then;
  answers_.warn("a jump of " + what, text.str());
}

void StepInput::setPaused(bool paused) {
  paused_ = paused;
  pacer_.restart();
}

void StepInput::restart(const Refused& refused) noexcept {
  commands_.refuseAll(refused);
  takeOver();
  pacer_.restart();
}

/// A body that nobody led, as it stands.
void StepInput::takeOver() noexcept {
  for (std::size_t i = 0; i < tools_.size(); ++i) tools_[i].takeOver(body_.toolPose(i));
  obstacles_.restart();
  clamps_.restart();
}

LeadsMemory StepInput::keep() const {
  LeadsMemory memory{{}, obstacles_.keep(), clamps_.keep()};
  for (const ToolGuide& tool : tools_) memory.tools.push_back(tool.keep());
  return memory;
}

void StepInput::recall(std::optional<LeadsMemory> memory, const Refused& refused) noexcept {
  commands_.refuseAll(refused, [&](std::size_t tool) { return !memory || memory->tools[tool].active; });
  if (memory) {
    for (std::size_t i = 0; i < tools_.size(); ++i) tools_[i].recall(std::move(memory->tools[i]));
    obstacles_.recall(memory->obstacles);
    clamps_.recall(memory->clamps);
  } else {
    takeOver();
  }
  pacer_.restart();
}

std::uint64_t StepInput::ignored() const {
  std::uint64_t sum = obstacles_.ignored() + clamps_.ignored();
  for (const ToolGuide& tool : tools_) sum += tool.ignored();
  return sum;
}

}  // namespace incision
