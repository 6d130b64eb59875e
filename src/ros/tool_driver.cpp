#include "incision/ros/tool_driver.h"

#include <geometry_msgs/WrenchStamped.h>
#include <ros/console.h>

#include <algorithm>
#include <utility>

#include "incision/ros/conversions.h"
#include "incision/ros/tf_frames.h"

namespace incision {
namespace {

/// Wrenches that may wait for a slow subscriber: a controller wants the newest, a recorder all.
constexpr std::uint32_t WRENCH_QUEUE = 100;

/// Least time [s] between two warnings of jumps.
constexpr double WARNING_PERIOD = 2;

std::string wrenchFrame(const ToolSettings& tool) {
  if (!tool.frame.empty()) return tool.frame;
  return tool.link.empty() ? "tool" : tool.link;
}

}  // namespace

ToolDriver::ToolDriver(ros::NodeHandle& node, std::size_t tool, const ToolEntry& entry, const Edge& edge,
                       const Frames& frames, double time_step)
    : tool_(tool),
      settings_(entry.settings),
      wrench_frame_(wrenchFrame(entry.settings)),
      lookup_(frames, warnOfLinks("the tool")),
      tracker_(entry.settings, edge, time_step),
      publisher_(node.advertise<geometry_msgs::WrenchStamped>(entry.topic("wrench"), WRENCH_QUEUE)) {}

std::vector<CutResult> ToolDriver::lead(ToolInput input, const StepTime& time, DeformableBody* body) {
  if (!settings_.frame.empty()) addFrame(time, &input);
  const ToolMove move = tracker_.follow(input, time.start, time.single);
  log(move);
  std::vector<CutResult> ended;
  if (const auto stroke = body->activateTool(move.active, tool_)) ended.push_back(*stroke);
  if (move.placed)
    if (const auto stroke = body->placeTool(*move.placed, tool_)) ended.push_back(*stroke);
  if (!move.path.empty()) body->guideTool(move.path, tool_);
  active_ = move.active;
  received_ = move.received;
  return ended;
}

void ToolDriver::log(const ToolMove& move) const {
  if (move.came_again) ROS_INFO("the tool's poses come again");
  if (move.jump)
    ROS_WARN_STREAM_THROTTLE(WARNING_PERIOD, "the tool's pose jumped by " << *move.jump << " m (followed: up to "
                                                                          << settings_.max_step
                                                                          << " m): a new stroke begins there");
  if (move.went_stale)
    ROS_WARN_STREAM("no pose of the tool for more than " << settings_.timeout << " s: it holds still where it is");
}

/// A transform is received when its stamp is first seen; static ones have none, and are always new.
void ToolDriver::addFrame(const StepTime& time, ToolInput* input) {
  const auto found = lookup_.find(settings_.frame, time.end);
  if (!found || (found->stamp != 0 && found->stamp == frame_stamp_)) return;
  frame_stamp_ = found->stamp;
  input->poses.push_back({found->pose, time.start, std::chrono::steady_clock::now(), input->active});
}

/// What the step says of the tool; before the first step there is nothing to say.
const ToolReport& ToolDriver::reportIn(const StepResult& step) const {
  static const ToolReport none;
  return tool_ < step.tools.size() ? step.tools[tool_] : none;
}

void ToolDriver::publishWrench(const StepResult& step) { publishWrench(reportIn(step)); }

void ToolDriver::publishWrench(const ToolReport& report) {
  if (tracker_.stale()) {
    if (!std::exchange(said_stale_, true)) publish(ros::Time(), Vec3::Zero(), Vec3::Zero());
    pressed_ = false;
  } else {
    said_stale_ = false;
    if (report.touching) publish(ros::Time::now(), report.force, report.torque);
    if (!report.touching && pressed_) publish(ros::Time::now(), Vec3::Zero(), Vec3::Zero());
    pressed_ = report.touching;
  }
  latency_ = received_ ? std::chrono::duration<double>(std::chrono::steady_clock::now() - *received_).count() : 0;
}

void ToolDriver::publish(const ros::Time& stamp, const Vec3& force, const Vec3& torque) {
  geometry_msgs::WrenchStamped message;
  message.header.stamp = stamp;
  message.header.frame_id = wrench_frame_;
  message.wrench.force = toVector3(force);
  message.wrench.torque = toVector3(torque);
  publisher_.publish(message);
}

std::optional<CutResult> ToolDriver::restart(DeformableBody* body) {
  tracker_.restart();
  frame_stamp_.reset();
  received_.reset();
  active_ = true;
  publishWrench(ToolReport());
  return body->liftTool(tool_);
}

void ToolDriver::addTo(const StepResult& step, BodyState* state) const {
  const ToolReport& report = reportIn(step);
  state->tool_active |= static_cast<std::uint8_t>(active_);
  state->tool_stale |= static_cast<std::uint8_t>(tracker_.stale());
  state->tool_depth = std::max(state->tool_depth, report.depth);
  state->stroke_area += report.stroke_area;
  state->tool_jumps += tracker_.jumps();
  state->tool_latency = std::max(state->tool_latency, latency_);
  state->ignored_transforms += lookup_.ignored();
}

}  // namespace incision
