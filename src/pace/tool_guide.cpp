#include "incision/pace/tool_guide.h"

#include <sstream>
#include <utility>

namespace incision {

ToolGuide::ToolGuide(std::size_t tool, const Scene& scene, const ToolForm& form, const Frames& frames, Answers& answers)
    : tool_(tool),
      settings_(scene.tools[tool]),
      answers_(answers),
      lookup_(frames, warnOfLinks("the tool '" + settings_.name + "'", answers)),
      tracker_(settings_, form.extent, scene.solver.time_step),
      jaw_(scene.solver.time_step) {}

void check(const ToolGuideMemory& memory, const MemoryLimits& limits) {
  check(memory.tracker, limits);
  check(memory.jaw, limits);
}

void ToolGuide::recall(ToolGuideMemory memory) noexcept {
  active_ = memory.tracker.active;
  tracker_.recall(std::move(memory.tracker));
  jaw_.recall(memory.jaw);
  frame_stamp_ = memory.frame_stamp;
  told_active_ = memory.active;
  received_.reset();
}

void ToolGuide::takeOver(const std::optional<Pose>& pose) noexcept {
  tracker_.restart(pose);
  jaw_.restart();
  frame_stamp_.reset();
  active_ = told_active_ = true;
  received_.reset();
}

void ToolGuide::lead(ToolInput input, const StepTime& time, DeformableBody* body) {
  if (!settings_.frame.empty()) addFrame(time, &input);
  told_active_ = input.active;
  const ToolMove move = tracker_.follow(input, time.start, time.single);
  tell(move);
  if (const auto stroke = body->activateTool(move.active, tool_)) answers_.report(*stroke);
  if (move.placed)
    if (const auto stroke = body->placeTool(*move.placed, tool_)) answers_.report(*stroke);
  if (!move.path.empty()) body->guideTool(move.path, tool_);
  if (const auto angle = jaw_.follow(input.jaw, time.start, time.single)) body->guideJaw(*angle, tool_);
  active_ = move.active;
  received_ = move.received;
}

void ToolGuide::tell(const ToolMove& move) const {
  const std::string tool = "tool '" + settings_.name + "': ";
  if (move.came_again) answers_.inform(tool + "its poses come again");
  if (move.jump) {
    std::ostringstream text;
    text << tool << "its pose jumped by " << *move.jump << " m (followed: up to " << settings_.max_step
         << " m): it is put there at once";
    answers_.warn("a jump of " + tool, text.str());
  }
  if (move.went_stale) {
    std::ostringstream text;
    text << tool << "no pose for more than " << settings_.timeout << " s: it holds still where it is";
    answers_.warn("the age of " + tool, text.str());
  }
}

/// A transform is received when its stamp is first seen; static ones have none, and are always new.
void ToolGuide::addFrame(const StepTime& time, ToolInput* input) {
  const auto found = lookup_.find(settings_.frame, time.end);
  if (!found || (found->stamp != 0 && found->stamp == frame_stamp_)) return;
  frame_stamp_ = found->stamp;
  input->poses.push_back({found->pose, time.start, steadyNow(), input->active});
}

}  // namespace incision
