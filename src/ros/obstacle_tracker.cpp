#include "incision/ros/obstacle_tracker.h"

#include <ros/console.h>

#include <algorithm>
#include <cmath>

#include "incision/ros/conversions.h"
#include "incision/ros/validation.h"

namespace incision {
namespace {

/// Least time [s] between two warnings of one kind.
constexpr double WARNING_PERIOD = 2;

bool isUsable(const Pose& pose) {
  return pose.position.allFinite() && pose.position.cwiseAbs().maxCoeff() <= MAX_POSITION &&
         std::abs(pose.orientation.norm() - 1) <= QUATERNION_TOLERANCE;
}

bool same(const Pose& a, const Pose& b) {
  return a.position == b.position && a.orientation.coeffs() == b.orientation.coeffs();
}

/// At least as far [m] as anything moves that is within `reach` of the origin.
double travel(const Pose& from, const Pose& to, double reach) {
  return (to.position - from.position).norm() + reach * from.orientation.angularDistance(to.orientation);
}

}  // namespace

ObstacleTracker::ObstacleTracker(const tf2::BufferCore& buffer, std::string body_frame, const Obstacles& obstacles,
                                 double time_step)
    : buffer_(buffer), body_frame_(std::move(body_frame)), time_step_(time_step) {
  for (const ObstacleLink& link : obstacles.links) {
    links_.emplace_back();
    links_.back().name = link.name;
    links_.back().described = link.pose;
  }
  for (const Obstacle& obstacle : obstacles.shapes) {
    if (obstacle.link == GROUND_LINK) continue;
    double& reach = links_[static_cast<std::size_t>(obstacle.link)].reach;
    reach = std::max(reach, obstacle.pose.position.norm() + obstacle.shape.size.norm());
  }
  restart();
}

void ObstacleTracker::restart() {
  poses_.clear();
  for (Link& link : links_) {
    poses_.push_back(link.described);
    link.target = link.described;
    link.steps_left = 0;
    link.found = false;
  }
}

std::vector<LinkMove> ObstacleTracker::follow(Nanoseconds end) {
  std::vector<LinkMove> moves;
  for (std::size_t i = 0; i < links_.size(); ++i) {
    Link& link = links_[i];
    const std::optional<Target> target = lookUp(link.name, end);
    const bool jumps = target && aim(*target, poses_[i], &link);
    if (link.steps_left == 0) continue;
    poses_[i] = between(poses_[i], link.target, 1.0 / link.steps_left);
    --link.steps_left;
    moves.push_back({static_cast<int>(i), poses_[i], jumps});
  }
  return moves;
}

/// Returns whether the link, now at `pose`, is put at the target rather than moved there.
bool ObstacleTracker::aim(const Target& target, const Pose& pose, Link* link) const {
  const double period = 1e-9 * static_cast<double>(target.stamp - link->stamp);
  const bool first = !link->found;
  link->stamp = target.stamp;
  link->found = true;
  if (same(target.pose, link->target)) return false;
  link->target = target.pose;
  link->steps_left = std::max(1, static_cast<int>(std::lround(std::min(period, MAX_TRANSFORM_PERIOD) / time_step_)));
  const double speed = travel(pose, link->target, link->reach) / (link->steps_left * time_step_);
  if (!first && speed <= MAX_OBSTACLE_SPEED) return false;
  if (!first)
    ROS_WARN_STREAM_THROTTLE(WARNING_PERIOD, "link \"" << link->name << "\" of the obstacles jumped, at " << speed
                                                       << " m/s (followed: up to " << MAX_OBSTACLE_SPEED << " m/s)");
  link->steps_left = 1;
  return true;
}

std::optional<ObstacleTracker::Target> ObstacleTracker::lookUp(const std::string& name, Nanoseconds end) {
  if (name == body_frame_ || !buffer_._frameExists(name)) return std::nullopt;
  try {
    const bool known = end > 0 && buffer_.canTransform(body_frame_, name, toRos(end));
    if (known || buffer_.canTransform(body_frame_, name, ros::Time())) {
      const auto found = buffer_.lookupTransform(body_frame_, name, known ? toRos(end) : ros::Time());
      const Pose pose = toPose(found.transform);
      if (isUsable(pose)) return Target{pose, static_cast<Nanoseconds>(found.header.stamp.toNSec())};
      ignore(name, "its transform is not finite, or further than 1e9 m");
    } else {
      ignore(name, "tf knows it, but not where it is in \"" + body_frame_ + "\"");
    }
  } catch (const std::exception& error) {  // tf changed meanwhile, or a stamp is too far off to subtract
    ignore(name, error.what());
  }
  return std::nullopt;
}

void ObstacleTracker::ignore(const std::string& name, const std::string& why) {
  ++ignored_;
  ROS_WARN_STREAM_THROTTLE(WARNING_PERIOD, "link \"" << name << "\" of the obstacles stays where it is: " << why);
}

}  // namespace incision
