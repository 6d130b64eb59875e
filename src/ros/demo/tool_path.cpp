#include "incision/ros/demo/tool_path.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <limits>

namespace incision {

ToolPath::ToolPath(const std::vector<Pose>& waypoints, double speed, bool loop) : loop_(loop && waypoints.size() > 1) {
  assert(!waypoints.empty() && speed > 0);
  waypoints_.push_back({0, waypoints.front()});
  const auto add = [&](const Pose& next) {
    const TimedPose& last = waypoints_.back();
    waypoints_.push_back({last.time + (next.position - last.pose.position).norm() / speed, next});
  };
  std::for_each(waypoints.begin() + 1, waypoints.end(), add);
  if (loop_) add(waypoints.front());
}

Pose ToolPath::at(double time) const {
  if (loop_) time = std::fmod(time, waypoints_.back().time);
  const auto next = std::upper_bound(waypoints_.begin(), waypoints_.end(), time,
                                     [](double t, const TimedPose& waypoint) { return t < waypoint.time; });
  if (next == waypoints_.end()) return waypoints_.back().pose;
  const auto last = next - 1;
  return between(last->pose, next->pose, (time - last->time) / (next->time - last->time));
}

double ToolPath::duration() const { return loop_ ? std::numeric_limits<double>::infinity() : waypoints_.back().time; }

}  // namespace incision
