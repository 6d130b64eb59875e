#include "incision/pace/obstacle_tracker.h"

#include <algorithm>
#include <utility>

namespace incision {
namespace {

bool same(const Pose& a, const Pose& b) {
  return a.position == b.position && a.orientation.coeffs() == b.orientation.coeffs();
}

/// At least as far [m] as anything moves that is within `reach` of the origin.
double travel(const Pose& from, const Pose& to, double reach) {
  return (to.position - from.position).norm() + reach * from.orientation.angularDistance(to.orientation);
}

}  // namespace

ObstacleTracker::ObstacleTracker(LinkLookup lookup, const Obstacles& obstacles, double time_step)
    : lookup_(std::move(lookup)), time_step_(time_step) {
  for (const ObstacleLink& link : obstacles.links) {
    links_.emplace_back();
    links_.back().name = link.name;
    links_.back().described = link.pose;
  }
  for (const Obstacle& obstacle : obstacles.shapes) {
    if (obstacle.link == GROUND_LINK) continue;
    Link& link = links_[static_cast<std::size_t>(obstacle.link)];
    link.reach = std::max(link.reach, obstacle.pose.position.norm() + obstacle.solid->reach());
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
    Link& link = links_[i];
    LinkMove move = {static_cast<int>(i), poses_[i]};
    if (const auto target = lookup_.find(link.name, end)) aim(*target, &link, &move);
    const double share = link.approach.takeShare();
    if (share == 0) continue;
    poses_[i] = move.pose = between(poses_[i], link.target, share);
    moves.push_back(move);
  }
  return moves;
}

/// The link, which is where the move has it now, goes to the target from now on.
void ObstacleTracker::aim(const StampedPose& target, Link* link, LinkMove* move) const {
  const double period = 1e-9 * static_cast<double>(target.stamp - link->stamp);
  const bool first = !link->found;
  link->stamp = target.stamp;
  link->found = true;
  if (same(target.pose, link->target)) return;
  link->target = target.pose;
  link->approach.aim(period, time_step_);
  const double speed = travel(move->pose, link->target, link->reach) / (link->approach.stepsLeft() * time_step_);
  if (!first && speed <= MAX_OBSTACLE_SPEED) return;
  if (!first) move->jump_speed = speed;
  move->at_once = true;
  link->approach.arriveInOneStep();
}

}  // namespace incision
