#include "incision/ros/demo/tool_path.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <limits>

namespace incision {

ToolPath::ToolPath(const std::vector<Waypoint>& waypoints, double speed, bool loop)
    : loop_(loop && waypoints.size() > 1) {
  assert(!waypoints.empty() && speed > 0);
  stops_.push_back({0, waypoints.front()});
  const auto add = [&](const Waypoint& next) {
    const auto& [time, last] = stops_.back();
    const double distance = (next.place.pose.position - last.place.pose.position).norm();
    stops_.push_back({time + std::max(distance / speed, last.leg_time), next});
  };
  std::for_each(waypoints.begin() + 1, waypoints.end(), add);
  if (loop_) add(waypoints.front());
}

ToolPlace ToolPath::at(double time) const {
  if (loop_) time = std::fmod(time, stops_.back().time);
  const auto next =
      std::upper_bound(stops_.begin(), stops_.end(), time, [](double t, const Stop& stop) { return t < stop.time; });
  if (next == stops_.end()) return stops_.back().waypoint.place;
  const auto last = next - 1;
  const double share = (time - last->time) / (next->time - last->time);
  const ToolPlace &from = last->waypoint.place, &to = next->waypoint.place;
  return {between(from.pose, to.pose, share), from.jaw + share * (to.jaw - from.jaw)};
}

double ToolPath::duration() const { return loop_ ? std::numeric_limits<double>::infinity() : stops_.back().time; }

}  // namespace incision
