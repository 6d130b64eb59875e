#include "incision/tool/tool.h"

#include <algorithm>
#include <utility>

namespace incision {
namespace {

/// Whether the scene tells what is then. Before its first entry and after its last it does not.
template <class Series>
bool tells(const Series& series, double time) {
  return !series.empty() && time >= series.front().time - DUE_TOLERANCE && time <= series.back().time + DUE_TOLERANCE;
}

}  // namespace

Tool::Tool(const ToolSettings& settings, Touching touching) : settings_(settings), touching_(std::move(touching)) {
  for (const auto& contact : touching_) contact->setTool(&in_step_);
}

ToolForm Tool::form() const {
  ToolForm form;
  form.groups = groups();
  for (int g = 0; g < form.groups; ++g) form.shapes.links.push_back({settings_.link, Pose()});
  for (const auto& contact : touching_)
    for (Obstacle shape : contact->shapes().shapes) {
      shape.link = contact->group();
      form.shapes.shapes.push_back(shape);
    }
  form.extent = extentOf(form.shapes);
  return form;
}

Edge Tool::extentOf(const Obstacles& shapes) const {
  double reach = 0;
  for (const Obstacle& shape : shapes.shapes)
    reach = std::max(reach, placed(shape.pose.position, groupPose(shape.link, jaw())).norm() + shape.solid->reach());
  return {Vec3(reach, 0, 0), Vec3(0, reach, 0)};
}

std::vector<Coupler*> Tool::couplers() {
  std::vector<Coupler*> list;
  for (const auto& contact : touching_) list.push_back(contact.get());
  return list;
}

void Tool::guide(const std::vector<Pose>& path) {
  tool_.path.reserve(tool_.path.size() + path.size());  // nothing has changed where there is no room
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
  const std::size_t count = static_cast<std::size_t>(groups());
  way_.clear();
  in_step_.in_place = from.has_value();
  in_step_.active = tool_.active;
  in_step_.groups.assign(count, RigidMotion());
  in_step_.felt.assign(count, Wrench());
  startJaw(time, time_step);
  if (!from) return;
  way_ = tool_.path;
  if (const std::optional<Pose> pose = scriptedPose(time + time_step)) way_.push_back(*pose);
  if (way_.empty() && in_step_.jaw_to != in_step_.jaw_from) way_.push_back(*from);
  findWays(*from);
  for (std::size_t g = 0; g < ways_.size(); ++g) in_step_.groups[g] = {ways_[g].front(), ways_[g].back()};
  start(x);
}

/// What is not in place turns its joint at once.
void Tool::startJaw(double time, double time_step) {
  in_step_.jaw_from = tool_.pose ? tool_.jaw : scriptedJaw(time).value_or(tool_.jaw);
  in_step_.jaw_to = tool_.jaw_to.value_or(scriptedJaw(time + time_step).value_or(in_step_.jaw_from));
  if (!in_step_.in_place) in_step_.jaw_from = in_step_.jaw_to;
}

/// The joint turns evenly while the link goes from here along its way.
void Tool::findWays(const Pose& from) {
  const double turn = in_step_.jaw_to - in_step_.jaw_from, legs = static_cast<double>(way_.size());
  ways_.resize(in_step_.groups.size());
  for (std::size_t g = 0; g < ways_.size(); ++g) {
    const int group = static_cast<int>(g);
    ways_[g].clear();
    ways_[g].push_back(composed(from, groupPose(group, in_step_.jaw_from)));
    for (std::size_t k = 0; k < way_.size(); ++k) {
      const double share = static_cast<double>(k + 1) / legs;
      ways_[g].push_back(composed(way_[k], groupPose(group, in_step_.jaw_from + share * turn)));
    }
  }
}

std::optional<CutResult> Tool::endStep(double time_step, const Motion& motion, MeshDoor* door) {
  tool_.jaw = in_step_.jaw_to;
  tool_.jaw_to.reset();
  if (!in_step_.in_place) return std::nullopt;
  tool_.pose = in_step_.groups[0].to;
  tool_.path.clear();
  if (!in_step_.active) return interrupt();
  return act(time_step, motion, door);
}

ToolReport Tool::report() const {
  ToolReport report;
  if (!tool_.pose || in_step_.felt.empty()) return report;
  Wrench sum;
  for (const Wrench& felt : in_step_.felt) sum += felt;
  const Wrench felt = seenFrom(in_step_.groups[0].from, sum);
  report.force = felt.force;
  report.torque = felt.torque;
  report.touching = !felt.force.isZero(0);
  report.jaw = tool_.jaw;
  return report;
}

/// The pose that the scene gives for a time, if it gives one.
std::optional<Pose> Tool::scriptedPose(double at) const {
  if (!tells(settings_.poses, at)) return std::nullopt;
  return poseAt(settings_.poses, at);
}

std::optional<double> Tool::scriptedJaw(double at) const {
  if (!settings_.jaw || !tells(settings_.jaw->angles, at)) return std::nullopt;
  return angleAt(settings_.jaw->angles, at);
}

}  // namespace incision
