#include "incision/tool/tool.h"

#include <algorithm>
#include <utility>

namespace incision {

Tool::Tool(const ToolSettings& settings, std::unique_ptr<ToolContact> touching)
    : settings_(settings), touching_(std::move(touching)) {
  if (touching_) touching_->setTool(&in_step_);
}

const Obstacles& Tool::shapes() const {
  static const Obstacles none;
  return touching_ ? touching_->shapes() : none;
}

std::vector<Coupler*> Tool::couplers() {
  if (!touching_) return {};
  return {touching_.get()};
}

void Tool::guide(const std::vector<Pose>& path) {
  auto next = path.begin();
  if (!tool_.pose && next != path.end()) tool_.pose = *next++;
  tool_.path.insert(tool_.path.end(), next, path.end());
}

std::optional<CutResult> Tool::place(const Pose& pose) {
  tool_.pose = pose;
  tool_.path.clear();
  return interrupt();
}

std::optional<CutResult> Tool::lift() {
  tool_.pose.reset();
  tool_.path.clear();
  return interrupt();
}

std::optional<CutResult> Tool::activate(bool active) {
  if (active == tool_.active) return std::nullopt;
  tool_.active = active;
  return interrupt();
}

void Tool::startStep(double time, double time_step, const std::vector<Vec3>& x) {
  const std::optional<Pose> from = tool_.pose ? tool_.pose : scriptedPose(time);
  way_.clear();
  in_step_ = ToolInStep();
  in_step_.in_place = from.has_value();
  in_step_.active = tool_.active;
  if (!from) return;
  way_ = tool_.path;
  if (const std::optional<Pose> pose = scriptedPose(time + time_step)) way_.push_back(*pose);
  in_step_.motion = {*from, way_.empty() ? *from : way_.back()};
  start(*from, x);
}

std::optional<CutResult> Tool::endStep(double time_step, const Motion& motion, MeshDoor* door) {
  if (!in_step_.in_place) return std::nullopt;
  tool_.pose = in_step_.motion.to;
  tool_.path.clear();
  if (!in_step_.active) return std::nullopt;
  return act(in_step_.motion.from, way_, time_step, motion, door);
}

ToolReport Tool::report() const {
  ToolReport report;
  if (!tool_.pose) return report;
  const Wrench felt = seenFrom(in_step_.motion.from, in_step_.felt);
  report.force = felt.force;
  report.torque = felt.torque;
  report.touching = !felt.force.isZero(0);
  return report;
}

/// The pose that the scene gives for a time, if it gives one.
std::optional<Pose> Tool::scriptedPose(double at) const {
  const std::vector<TimedPose>& poses = settings_.poses;
  if (poses.empty() || at < poses.front().time - DUE_TOLERANCE || at > poses.back().time + DUE_TOLERANCE)
    return std::nullopt;
  return poseAt(poses, at);
}

}  // namespace incision
