#include "incision/ros/tool_publisher.h"

#include <utility>

#include "incision/ros/conversions.h"

namespace incision {
namespace {

/// Messages that may wait for a slow subscriber: a controller wants the newest, a recorder all.
constexpr std::uint32_t MEASURED_QUEUE = 100;

std::string wrenchFrame(const ToolSettings& tool) {
  if (!tool.frame.empty()) return tool.frame;
  return tool.link.empty() ? tool.name : tool.link;
}

}  // namespace

ToolPublisher::ToolPublisher(ros::NodeHandle& node, std::size_t tool, const Scene& scene, PublishingThread* thread)
    : tool_(tool),
      name_(scene.tools[tool].name),
      joint_(scene.tools[tool].jaw ? scene.tools[tool].jaw->joint : ""),
      body_frame_(scene.body.frame),
      wrench_frame_(wrenchFrame(scene.tools[tool])),
      poses_(thread, node.advertise<geometry_msgs::PoseStamped>(name_ + "/measured_cp", MEASURED_QUEUE),
             MEASURED_QUEUE),
      wrenches_(thread, node.advertise<geometry_msgs::WrenchStamped>(name_ + "/measured_cf", MEASURED_QUEUE),
                MEASURED_QUEUE) {
  if (scene.tools[tool].jaw)
    jaws_ = {thread, node.advertise<sensor_msgs::JointState>(name_ + "/jaw/measured_js", MEASURED_QUEUE),
             MEASURED_QUEUE};
}

/// What the step says of the tool; before the first step there is nothing to say.
const ToolReport& ToolPublisher::reportIn(const StepResult& step) const {
  static const ToolReport none;
  return tool_ < step.tools.size() ? step.tools[tool_] : none;
}

void ToolPublisher::publish(const StepResult& step, const DeformableBody& body, const ToolGuide& guide) {
  const ros::Time now = ros::Time::now();
  const ToolReport& report = reportIn(step);
  const std::optional<Pose>& pose = body.toolPose(tool_);
  const bool valid = pose && !guide.stale();
  if (pose) publishPose(*pose, now);
  publishJaw(report, now);
  if (valid)
    publishWrench(report, now);
  else if (valid_)
    publishWrench(ToolReport(), ros::Time());
  valid_ = valid;
  const auto& received = guide.received();
  latency_ = received ? std::chrono::duration<double>(steadyNow() - *received).count() : 0;
}

void ToolPublisher::publishPose(const Pose& pose, const ros::Time& stamp) {
  if (!poses_.wanted()) return;
  poses_.give([&](geometry_msgs::PoseStamped* message) {
    message->header.stamp = stamp;
    message->header.frame_id = body_frame_;
    message->pose = toPoseMessage(pose);
  });
}

void ToolPublisher::publishJaw(const ToolReport& report, const ros::Time& stamp) {
  if (!jaws_.wanted()) return;
  jaws_.give([&](sensor_msgs::JointState* message) {
    message->header.stamp = stamp;
    message->name.assign(1, joint_);
    message->position.assign(1, report.jaw);
    message->effort.assign(1, report.jaw_torque);
  });
}

void ToolPublisher::publishWrench(const ToolReport& report, const ros::Time& stamp) {
  if (!wrenches_.wanted()) return;
  wrenches_.give([&](geometry_msgs::WrenchStamped* message) {
    message->header.stamp = stamp;
    message->header.frame_id = wrench_frame_;
    message->wrench.force = toVector3(report.force);
    message->wrench.torque = toVector3(report.torque);
  });
}

void ToolPublisher::restart() {
  if (std::exchange(valid_, false)) publishWrench(ToolReport(), ros::Time());
}

ToolState ToolPublisher::state(const StepResult& step, const DeformableBody& body, const ToolGuide& guide) const {
  const ToolReport& report = reportIn(step);
  ToolState state;
  state.name = name_;
  state.in_place = static_cast<std::uint8_t>(body.toolPose(tool_).has_value());
  state.active = static_cast<std::uint8_t>(guide.active());
  state.stale = static_cast<std::uint8_t>(guide.stale());
  state.depth = report.depth;
  state.area = report.stroke_area;
  state.jaw = body.toolJaw(tool_);
  state.gripped = report.gripped;
  state.jumps = guide.jumps();
  state.latency = latency_;
  return state;
}

}  // namespace incision
