#include "incision/ros/tool_driver.h"

#include <geometry_msgs/PoseStamped.h>
#include <geometry_msgs/WrenchStamped.h>
#include <ros/console.h>
#include <sensor_msgs/JointState.h>

#include <utility>

#include "incision/ros/conversions.h"
#include "incision/ros/tf_frames.h"

namespace incision {
namespace {

/// Messages that may wait for a slow subscriber: a controller wants the newest, a recorder all.
constexpr std::uint32_t MEASURED_QUEUE = 100;

/// Least time [s] between two warnings of jumps.
constexpr double WARNING_PERIOD = 2;

std::string wrenchFrame(const ToolSettings& tool) {
  if (!tool.frame.empty()) return tool.frame;
  return tool.link.empty() ? tool.name : tool.link;
}

}  // namespace

ToolDriver::ToolDriver(ros::NodeHandle& node, std::size_t tool, const Scene& scene, const ToolForm& form,
                       const Frames& frames)
    : tool_(tool),
      settings_(scene.tools[tool]),
      body_frame_(scene.body.frame),
      wrench_frame_(wrenchFrame(settings_)),
      lookup_(frames, warnOfLinks("the tool '" + settings_.name + "'")),
      tracker_(settings_, form.extent, scene.solver.time_step),
      jaw_(scene.solver.time_step),
      pose_publisher_(node.advertise<geometry_msgs::PoseStamped>(settings_.name + "/measured_cp", MEASURED_QUEUE)),
      wrench_publisher_(node.advertise<geometry_msgs::WrenchStamped>(settings_.name + "/measured_cf", MEASURED_QUEUE)) {
  if (settings_.jaw)
    jaw_publisher_ = node.advertise<sensor_msgs::JointState>(settings_.name + "/jaw/measured_js", MEASURED_QUEUE);
}

void check(const ToolDriverMemory& memory, const MemoryLimits& limits) {
  check(memory.tracker, limits);
  check(memory.jaw, limits);
}

void ToolDriver::recall(const ToolDriverMemory& memory) {
  tracker_.recall(memory.tracker);
  jaw_.recall(memory.jaw);
  frame_stamp_ = memory.frame_stamp;
  active_ = memory.tracker.active;
  told_active_ = memory.active;
  received_.reset();
}

void ToolDriver::takeOver(const std::optional<Pose>& pose) {
  tracker_.restart(pose);
  jaw_.restart();
  frame_stamp_.reset();
  active_ = told_active_ = true;
  received_.reset();
}

std::vector<CutResult> ToolDriver::lead(ToolInput input, const StepTime& time, DeformableBody* body) {
  if (!settings_.frame.empty()) addFrame(time, &input);
  told_active_ = input.active;
  const ToolMove move = tracker_.follow(input, time.start, time.single);
  log(move);
  std::vector<CutResult> ended;
  if (const auto stroke = body->activateTool(move.active, tool_)) ended.push_back(*stroke);
  if (move.placed)
    if (const auto stroke = body->placeTool(*move.placed, tool_)) ended.push_back(*stroke);
  if (!move.path.empty()) body->guideTool(move.path, tool_);
  if (const auto angle = jaw_.follow(input.jaw, time.start, time.single)) body->guideJaw(*angle, tool_);
  active_ = move.active;
  received_ = move.received;
  return ended;
}

void ToolDriver::log(const ToolMove& move) const {
  const std::string tool = "tool '" + settings_.name + "': ";
  if (move.came_again) ROS_INFO_STREAM(tool << "its poses come again");
  if (move.jump)
    ROS_WARN_STREAM_THROTTLE(WARNING_PERIOD, tool << "its pose jumped by " << *move.jump << " m (followed: up to "
                                                  << settings_.max_step << " m): it is put there at once");
  if (move.went_stale)
    ROS_WARN_STREAM(tool << "no pose for more than " << settings_.timeout << " s: it holds still where it is");
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

void ToolDriver::publish(const StepResult& step, const DeformableBody& body) {
  const ros::Time now = ros::Time::now();
  const ToolReport& report = reportIn(step);
  const std::optional<Pose>& pose = body.toolPose(tool_);
  const bool valid = pose && !tracker_.stale();
  if (pose) publishPose(*pose, now);
  if (jaw_publisher_) publishJaw(report, now);
  if (valid)
    publishWrench(report, now);
  else if (valid_)
    publishWrench(ToolReport(), ros::Time());
  valid_ = valid;
  latency_ = received_ ? std::chrono::duration<double>(std::chrono::steady_clock::now() - *received_).count() : 0;
}

void ToolDriver::publishPose(const Pose& pose, const ros::Time& stamp) {
  if (pose_publisher_.getNumSubscribers() == 0) return;
  geometry_msgs::PoseStamped message;
  message.header.stamp = stamp;
  message.header.frame_id = body_frame_;
  message.pose = toPoseMessage(pose);
  pose_publisher_.publish(message);
}

void ToolDriver::publishJaw(const ToolReport& report, const ros::Time& stamp) {
  if (jaw_publisher_.getNumSubscribers() == 0) return;
  sensor_msgs::JointState message;
  message.header.stamp = stamp;
  message.name = {settings_.jaw->joint};
  message.position = {report.jaw};
  message.effort = {report.jaw_torque};
  jaw_publisher_.publish(message);
}

void ToolDriver::publishWrench(const ToolReport& report, const ros::Time& stamp) {
  geometry_msgs::WrenchStamped message;
  message.header.stamp = stamp;
  message.header.frame_id = wrench_frame_;
  message.wrench.force = toVector3(report.force);
  message.wrench.torque = toVector3(report.torque);
  wrench_publisher_.publish(message);
}

std::optional<CutResult> ToolDriver::restart(DeformableBody* body) {
  takeOver(std::nullopt);
  if (std::exchange(valid_, false)) publishWrench(ToolReport(), ros::Time());
  return body->liftTool(tool_);
}

ToolState ToolDriver::state(const StepResult& step, const DeformableBody& body) const {
  const ToolReport& report = reportIn(step);
  ToolState state;
  state.name = settings_.name;
  state.in_place = static_cast<std::uint8_t>(body.toolPose(tool_).has_value());
  state.active = static_cast<std::uint8_t>(active_);
  state.stale = static_cast<std::uint8_t>(tracker_.stale());
  state.depth = report.depth;
  state.area = report.stroke_area;
  state.jaw = body.toolJaw(tool_);
  state.gripped = report.gripped;
  state.jumps = tracker_.jumps();
  state.latency = latency_;
  return state;
}

}  // namespace incision
