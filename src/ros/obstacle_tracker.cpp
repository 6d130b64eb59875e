#include "incision/ros/obstacle_tracker.h"

#include <ros/console.h>

#include <algorithm>

namespace incision {
namespace {

/// Least time [s] between two warnings of one kind.
constexpr double WARNING_PERIOD = 2;

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
    : lookup_(buffer, std::move(body_frame), "the obstacles"), tool_link_(obstacles.tool_link), time_step_(time_step) {
  for (const ObstacleLink& link : obstacles.links) {
    links_.emplace_back();
    links_.back().name = link.name;
    links_.back().described = link.pose;
  }
  for (const Obstacle& obstacle : obstacles.shapes) {
    if (obstacle.link == GROUND_LINK) continue;
    double& reach = links_[static_cast<std::size_t>(obstacle.link)].reach;
    reach = std::max(reach, obstacle.pose.position.norm() + obstacle.solid->reach());
  }
  restart();
}

void ObstacleTracker::restart() {
  poses_.clear();
  for (Link& link : links_) {
    poses_.push_back(link.described);
    link.target = link.described;
    link.approach.stop();
    link.found = false;
  }
}

std::vector<LinkMove> ObstacleTracker::follow(Nanoseconds end) {
  std::vector<LinkMove> moves;
  for (std::size_t i = 0; i < links_.size(); ++i) {
    if (static_cast<int>(i) == tool_link_) continue;
    Link& link = links_[i];
    const std::optional<LinkLookup::Found> target = lookup_.find(link.name, end);
    const bool jumps = target && aim(*target, poses_[i], &link);
    const double share = link.approach.takeShare();
    if (share == 0) continue;
    poses_[i] = between(poses_[i], link.target, share);
    moves.push_back({static_cast<int>(i), poses_[i], jumps});
  }
  return moves;
}

/// Returns whether the link, now at `pose`, is put at the target rather than moved there.
bool ObstacleTracker::aim(const LinkLookup::Found& target, const Pose& pose, Link* link) const {
  const double period = 1e-9 * static_cast<double>(target.stamp - link->stamp);
  const bool first = !link->found;
  link->stamp = target.stamp;
  link->found = true;
  if (same(target.pose, link->target)) return false;
  link->target = target.pose;
  link->approach.aim(period, time_step_);
  const double speed = travel(pose, link->target, link->reach) / (link->approach.stepsLeft() * time_step_);
  if (!first && speed <= MAX_OBSTACLE_SPEED) return false;
  if (!first)
    ROS_WARN_STREAM_THROTTLE(WARNING_PERIOD, "link \"" << link->name << "\" of the obstacles jumped, at " << speed
                                                       << " m/s (followed: up to " << MAX_OBSTACLE_SPEED << " m/s)");
  link->approach.hurry();
  return true;
}

}  // namespace incision
