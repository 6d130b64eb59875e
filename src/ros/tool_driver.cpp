#include "incision/ros/tool_driver.h"

#include <geometry_msgs/WrenchStamped.h>

#include "incision/ros/conversions.h"

namespace incision {
namespace {

/// Wrenches that may wait for a slow subscriber: a controller wants the newest, a recorder all.
constexpr std::uint32_t WRENCH_QUEUE = 100;

std::string wrenchFrame(const ToolSettings& tool) {
  if (!tool.frame.empty()) return tool.frame;
  return tool.link.empty() ? "tool" : tool.link;
}

}  // namespace

ToolDriver::ToolDriver(ros::NodeHandle& node, const Scene& scene, const Edge& edge, const tf2::BufferCore& buffer)
    : frame_(scene.tool->frame),
      wrench_frame_(wrenchFrame(*scene.tool)),
      lookup_(buffer, scene.body.frame, "the tool"),
      tracker_(*scene.tool, edge, scene.solver.time_step),
      publisher_(node.advertise<geometry_msgs::WrenchStamped>("tool_wrench", WRENCH_QUEUE)) {}

std::vector<CutResult> ToolDriver::lead(ToolInput input, const StepTime& time, DeformableBody* body) {
  if (!frame_.empty()) addFrame(time, &input);
  const ToolMove move = tracker_.follow(input, time.start, time.single);
  std::vector<CutResult> ended;
  if (const auto stroke = body->activateTool(move.active)) ended.push_back(*stroke);
  if (move.placed)
    if (const auto stroke = body->placeTool(*move.placed)) ended.push_back(*stroke);
  if (!move.path.empty()) body->guideTool(move.path);
  active_ = move.active;
  received_ = move.received;
  return ended;
}

/// A transform is received when its stamp is first seen; static ones have none, and are always new.
void ToolDriver::addFrame(const StepTime& time, ToolInput* input) {
  const auto found = lookup_.find(frame_, time.end);
  if (!found || (found->stamp != 0 && found->stamp == frame_stamp_)) return;
  frame_stamp_ = found->stamp;
  input->poses.push_back({found->pose, time.start, std::chrono::steady_clock::now(), input->active});
}

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

void ToolDriver::restart() {
  tracker_.restart();
  frame_stamp_.reset();
  received_.reset();
  active_ = true;
  publishWrench(ToolReport());
}

void ToolDriver::fillState(const ToolReport& report, BodyState* state) const {
  state->tool_active = active_;
  state->tool_stale = tracker_.stale();
  state->tool_depth = report.depth;
  state->stroke_area = report.stroke_area;
  state->tool_jumps = tracker_.jumps();
  state->tool_latency = latency_;
  state->ignored_transforms += lookup_.ignored();
}

}  // namespace incision
