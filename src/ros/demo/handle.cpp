#include "incision/ros/demo/handle.h"

#include <incision/CutPlane.h>
#include <ros/console.h>
#include <sensor_msgs/JointState.h>
#include <std_msgs/Bool.h>

#include <algorithm>
#include <cmath>

#include "incision/base/limits.h"
#include "incision/ros/conversions.h"
#include "incision/ros/demo/handle_markers.h"
#include "incision/ros/private_parameters.h"
#include "incision/ros/validation.h"

namespace incision {
namespace {

using interactive_markers::MenuHandler;
using visualization_msgs::InteractiveMarkerFeedback;

/// Messages that may wait for a slow subscriber: more than a hand makes in a second.
constexpr std::uint32_t QUEUE = 100;

constexpr Range SIZE = {ABOVE_ZERO, 1000};

/// Time [s] in which a jaw goes from open to closed, slowly enough to be watched.
constexpr double JAW_TIME = 1;

std::optional<JawAngles> loadJaw(const YamlMap& parameters) {
  if (!parameters.has("jaw_open") && !parameters.has("jaw_closed")) return std::nullopt;
  const auto angle = [&](const char* key) { return parameters.at(key).number({-MAX_COORDINATE, MAX_COORDINATE}); };
  return JawAngles{angle("jaw_open"), angle("jaw_closed")};
}

}  // namespace

HandleSettings loadHandleSettings(const ros::NodeHandle& node) {
  const YamlMap parameters =
      privateParameters(node, {"frame", "tool_frame", "rate", "tool_pose", "tool_size", "tool_axis", "jaw_open",
                               "jaw_closed", "plane", "plane_pose", "plane_size"});
  HandleSettings settings;
  settings.frame = frameParameter(parameters, "frame", settings.frame);
  settings.tool_frame = frameParameter(parameters, "tool_frame", settings.tool_frame);
  settings.rate = parameters.number("rate", settings.rate, {1, 1000});
  if (const auto pose = parameters.find("tool_pose")) settings.tool_pose = toPose(*pose);
  settings.tool_size = parameters.number("tool_size", settings.tool_size, SIZE);
  if (const auto axis = parameters.find("tool_axis"))
    settings.tool_axis = axis->choice<Vec3>({{"x", Vec3::UnitX()}, {"y", Vec3::UnitY()}, {"z", Vec3::UnitZ()}});
  settings.jaw = loadJaw(parameters);
  if (const auto plane = parameters.find("plane")) settings.plane = plane->boolean();
  if (const auto pose = parameters.find("plane_pose")) settings.plane_pose = toPose(*pose);
  if (const auto size = parameters.find("plane_size")) {
    const std::vector<YamlValue> sides = size->list(2);
    settings.plane_size = {sides[0].number(SIZE), sides[1].number(SIZE)};
  }
  return settings;
}

Handle::Handle(ros::NodeHandle& node, const HandleSettings& settings)
    : settings_(settings),
      publisher_(node, settings.tool_frame, QUEUE),
      active_publisher_(node.advertise<std_msgs::Bool>("active", 1, true)),
      server_(node.resolveName("markers")),
      timer_(node.createWallTimer(ros::WallDuration(1 / settings.rate),
                                  [this](const ros::WallTimerEvent&) { publishPose(); })) {
  addTool();
  if (settings.jaw) {
    jaw_publisher_ = node.advertise<sensor_msgs::JointState>("jaw", QUEUE);
    jaw_ = jaw_target_ = settings.jaw->open;
    addJawEntries();
  }
  tool_menu_.apply(server_, TOOL);
  if (settings.plane) {
    cut_publisher_ = node.advertise<CutPlane>("cut_plane", QUEUE);
    addPlane();
  }
  server_.applyChanges();
  publishActive();
}

void Handle::addTool() {
  pose_.header.frame_id = settings_.frame;
  pose_.pose = toPoseMessage(settings_.tool_pose);
  server_.insert(toolHandle(settings_.frame, settings_.tool_pose, settings_.tool_size, settings_.tool_axis));
  server_.setCallback(
      TOOL, [this](const Feedback& feedback) { moveTool(feedback); }, InteractiveMarkerFeedback::POSE_UPDATE);
  // What is off only touches: a blade cuts nothing, a jaw holds nothing.
  active_entry_ = tool_menu_.insert("on", [this](const Feedback&) { toggleTool(); });
  tool_menu_.setCheckState(active_entry_, MenuHandler::CHECKED);
}

void Handle::addJawEntries() {
  const auto& [open, closed] = *settings_.jaw;
  const auto add = [this](const std::string& title, double angle) {
    tool_menu_.insert(title, [this, angle](const Feedback&) { jaw_target_ = angle; });
  };
  add("jaw open", open);
  add("jaw half open", (open + closed) / 2);
  add("jaw closed", closed);
}

void Handle::addPlane() {
  const auto [length, width] = settings_.plane_size;
  server_.insert(planeHandle(settings_.frame, settings_.plane_pose, length, width));
  plane_menu_.insert("cut the rectangle", [this](const Feedback&) { cut(settings_.plane_size); });
  plane_menu_.insert("cut along the whole plane", [this](const Feedback&) { cut({0, 0}); });
  plane_menu_.apply(server_, PLANE);
}

void Handle::moveTool(const Feedback& feedback) {
  geometry_msgs::PoseStamped moved;
  moved.header.frame_id = feedback->header.frame_id;
  moved.pose = feedback->pose;
  if (const auto refused = whyRefused(moved)) {
    ROS_WARN_STREAM_THROTTLE(1, publisher_.topic() << ": the tool stays where it is: " << refused->reason);
    return;
  }
  pose_ = moved;
  publishPose();
}

/// Once more after a period without a move, not sooner: a pose repeated between two moves would look like a stop.
void Handle::publishPose() {
  const ros::Time now = ros::Time::now();
  if (jaw_publisher_) publishJaw(now);
  pose_.header.stamp = now;
  publisher_.publish(pose_);
  timer_.stop();
  timer_.start();
}

/// With each pose, on its even way to where it shall be. A clock that jumps moves it by a period at most.
void Handle::publishJaw(const ros::Time& time) {
  const double passed = std::clamp((time - pose_.header.stamp).toSec(), 0.0, 1 / settings_.rate);
  const double most = passed / JAW_TIME * std::abs(settings_.jaw->open - settings_.jaw->closed);
  jaw_ += std::clamp(jaw_target_ - jaw_, -most, most);
  sensor_msgs::JointState message;  // without a name: a tool has one jaw
  message.header.stamp = time;
  message.position = {jaw_};
  jaw_publisher_.publish(message);
}

void Handle::toggleTool() {
  active_ = !active_;
  tool_menu_.setCheckState(active_entry_, active_ ? MenuHandler::CHECKED : MenuHandler::UNCHECKED);
  tool_menu_.reApply(server_);
  server_.applyChanges();
  publishActive();
}

void Handle::publishActive() {
  std_msgs::Bool message;
  message.data = active_;
  active_publisher_.publish(message);
}

void Handle::cut(const std::array<double, 2>& size) {
  visualization_msgs::InteractiveMarker marker;
  server_.get(PLANE, marker);
  const Eigen::Quaterniond orientation = toPose(marker.pose).orientation;
  CutPlane plane;
  plane.header.frame_id = marker.header.frame_id;
  plane.label = "by hand " + std::to_string(++cuts_);
  plane.point = marker.pose.position;
  plane.normal = toVector3(orientation * Vec3::UnitZ());
  plane.tangent = toVector3(orientation * Vec3::UnitX());
  plane.length = size[0];
  plane.width = size[1];
  cut_publisher_.publish(plane);
}

}  // namespace incision
