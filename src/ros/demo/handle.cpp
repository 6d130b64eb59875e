#include "incision/ros/demo/handle.h"

#include <incision/CutPlane.h>
#include <ros/console.h>
#include <std_msgs/Bool.h>

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

}  // namespace

HandleSettings loadHandleSettings(const ros::NodeHandle& node) {
  const YamlMap parameters = privateParameters(
      node, {"frame", "tool_frame", "rate", "scalpel_pose", "scalpel_size", "plane_pose", "plane_size"});
  HandleSettings settings;
  settings.frame = frameParameter(parameters, "frame", settings.frame);
  settings.tool_frame = frameParameter(parameters, "tool_frame", settings.tool_frame);
  settings.rate = parameters.number("rate", settings.rate, {1, 1000});
  if (const auto pose = parameters.find("scalpel_pose")) settings.scalpel_pose = toPose(*pose);
  settings.scalpel_size = parameters.number("scalpel_size", settings.scalpel_size, SIZE);
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
      cut_publisher_(node.advertise<CutPlane>("cut_plane", QUEUE)),
      server_(node.resolveName("markers")),
      timer_(node.createWallTimer(ros::WallDuration(1 / settings.rate),
                                  [this](const ros::WallTimerEvent&) { publishPose(); })) {
  addScalpel();
  addPlane();
  server_.applyChanges();
  publishActive();
}

void Handle::addScalpel() {
  pose_.header.frame_id = settings_.frame;
  pose_.pose = toPoseMessage(settings_.scalpel_pose);
  server_.insert(scalpelHandle(settings_.frame, settings_.scalpel_pose, settings_.scalpel_size));
  server_.setCallback(
      SCALPEL, [this](const Feedback& feedback) { moveScalpel(feedback); }, InteractiveMarkerFeedback::POSE_UPDATE);
  blade_entry_ = scalpel_menu_.insert("blade on", [this](const Feedback&) { toggleBlade(); });
  scalpel_menu_.setCheckState(blade_entry_, MenuHandler::CHECKED);
  scalpel_menu_.apply(server_, SCALPEL);
}

void Handle::addPlane() {
  const auto [length, width] = settings_.plane_size;
  server_.insert(planeHandle(settings_.frame, settings_.plane_pose, length, width));
  plane_menu_.insert("cut the rectangle", [this](const Feedback&) { cut(settings_.plane_size); });
  plane_menu_.insert("cut along the whole plane", [this](const Feedback&) { cut({0, 0}); });
  plane_menu_.apply(server_, PLANE);
}

void Handle::moveScalpel(const Feedback& feedback) {
  geometry_msgs::PoseStamped moved;
  moved.header.frame_id = feedback->header.frame_id;
  moved.pose = feedback->pose;
  if (const auto refused = whyRefused(moved)) {
    ROS_WARN_STREAM_THROTTLE(1, "the scalpel stays where it is: " << refused->reason);
    return;
  }
  pose_ = moved;
  publishPose();
}

/// Once more after a period without a move, not sooner: a pose repeated between two moves would look like a stop.
void Handle::publishPose() {
  pose_.header.stamp = ros::Time::now();
  publisher_.publish(pose_);
  timer_.stop();
  timer_.start();
}

void Handle::toggleBlade() {
  active_ = !active_;
  scalpel_menu_.setCheckState(blade_entry_, active_ ? MenuHandler::CHECKED : MenuHandler::UNCHECKED);
  scalpel_menu_.reApply(server_);
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
