#include "incision/pace/link_tracker.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <utility>

namespace incision {
namespace {

/// Stands for the time of the last call while that is still to be known: later than any that ROS can say.
constexpr Nanoseconds LAST_CALL = Nanoseconds{1} << 62;

/// At least as far [m] as anything moves that is within `reach` of the origin.
double travel(const Pose& from, const Pose& to, double reach) {
  return (to.position - from.position).norm() + reach * from.orientation.angularDistance(to.orientation);
}

}  // namespace

std::vector<FollowedLink> linksOf(const Obstacles& obstacles) {
  std::vector<FollowedLink> links;
  for (const ObstacleLink& link : obstacles.links) links.push_back({link.name, link.pose});
  for (const Obstacle& obstacle : obstacles.shapes) {
    if (obstacle.link == GROUND_LINK) continue;
    FollowedLink& link = links[static_cast<std::size_t>(obstacle.link)];
    link.reach = std::max(link.reach, obstacle.pose.position.norm() + obstacle.solid->reach());
  }
  return links;
}

LinkTracker::LinkTracker(LinkLookup lookup, const std::vector<FollowedLink>& links, double time_step)
    : lookup_(std::move(lookup)), time_step_(time_step) {
  for (const FollowedLink& link : links) {
    links_.emplace_back();
    links_.back().followed = link;
  }
  poses_.resize(links_.size());
  restart();
}

void LinkTracker::restart() noexcept {
  for (std::size_t i = 0; i < links_.size(); ++i) {
    Link& link = links_[i];
    link.target = link.followed.start;
    poses_[i] = link.target.value_or(Pose());
    link.approach.stop();
    link.found = false;
  }
  resumed_ = false;
}

void check(const std::vector<FollowedLinkMemory>& memory, const MemoryLimits& limits) {
  for (const FollowedLinkMemory& link : memory) {
    check(link.pose, limits);
    if (link.target) check(*link.target, limits);
    require(!link.age || isRosTime(std::abs(*link.age)), "a transform's age is out of range");
    check(link.approach, limits);
    require(link.target || link.approach.stepsLeft() == 0, "a link goes nowhere");
  }
}

std::vector<FollowedLinkMemory> LinkTracker::keep() const {
  std::vector<FollowedLinkMemory> memory;
  for (std::size_t i = 0; i < links_.size(); ++i) {
    const Link& link = links_[i];
    std::optional<Nanoseconds> age;
    if (link.stamp != 0) age = last_call_ - link.stamp;
    memory.push_back({poses_[i], link.target, age, link.approach, link.found});
  }
  return memory;
}

void LinkTracker::recall(const std::vector<FollowedLinkMemory>& memory) noexcept {
  for (std::size_t i = 0; i < links_.size(); ++i) {
    const FollowedLinkMemory& kept = memory[i];
    Link& link = links_[i];
    poses_[i] = kept.pose;
    link.target = kept.target;
    link.stamp = kept.age ? LAST_CALL - *kept.age : 0;
    link.approach = kept.approach;
    link.found = kept.found;
  }
  last_call_ = LAST_CALL;
  resumed_ = true;
}

void LinkTracker::resume(Nanoseconds now) {
  if (!std::exchange(resumed_, false)) return;
  const Nanoseconds last = now - static_cast<Nanoseconds>(std::llround(1e9 * time_step_));
  for (Link& link : links_)
    if (link.stamp != 0) link.stamp += last - LAST_CALL;
}

std::optional<Nanoseconds> LinkTracker::stampOf(std::size_t link) const {
  if (!links_[link].found) return std::nullopt;
  return links_[link].stamp;
}

std::vector<LinkMove> LinkTracker::follow(Nanoseconds now, Nanoseconds end) {
  resume(now);
  last_call_ = now;
  std::vector<LinkMove> moves;
  for (std::size_t i = 0; i < links_.size(); ++i) {
    Link& link = links_[i];
    LinkMove move = {static_cast<int>(i), poses_[i]};
    if (const auto target = lookup_.find(link.followed.name, end)) aim(*target, &link, &move);
    const double share = link.approach.takeShare();
    if (share == 0) continue;
    poses_[i] = move.pose = between(poses_[i], *link.target, share);
    moves.push_back(move);
  }
  return moves;
}

/// The link, which is where the move has it now, goes to the target from now on.
void LinkTracker::aim(const StampedPose& target, Link* link, LinkMove* move) const {
  const double period = toSeconds(target.stamp - link->stamp);
  const bool first = !link->found;
  link->stamp = target.stamp;
  link->found = true;
  if (target.pose == link->target) return;
  link->target = target.pose;
  link->approach.aim(period, time_step_);
  const double speed =
      travel(move->pose, *link->target, link->followed.reach) / (link->approach.stepsLeft() * time_step_);
  if (!first && speed <= MAX_OBSTACLE_SPEED) return;
  if (!first) move->jump_speed = speed;
  move->at_once = true;
  link->approach.arriveInOneStep();
}

}  // namespace incision
