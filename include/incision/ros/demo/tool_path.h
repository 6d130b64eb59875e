#pragma once

#include <vector>

#include "incision/tool/settings.h"

namespace incision {

/// Where a tool is on its way.
struct ToolPlace {
  Pose pose;
  double jaw = 0;  ///< [rad] angle of its jaw, of a tool that has one
};

/// A place that a path leads through.
struct Waypoint {
  ToolPlace place;
  double leg_time = 0;  ///< [s] 0 or more: the leg from here to the next lasts at least so long
};

/// A way along straight legs from one waypoint to the next, at an even speed; on each leg the tool turns evenly, and so
/// does its jaw. A leg of a time between two places at the same position is a wait.
class ToolPath {
 public:
  /// `waypoints`: one or more; two neighbours at the same position need a leg time. `speed` [m/s] above 0. With `loop`
  /// the way leads from the last one back to the first, and so on.
  ToolPath(const std::vector<Waypoint>& waypoints, double speed, bool loop);

  /// Where the tool is after `time` [s], 0 or more. At the end it stays.
  ToolPlace at(double time) const;

  /// [s] from the start until it stays for good; infinite for a loop of more than one waypoint.
  double duration() const;

 private:
  struct Stop {
    double time;  ///< [s] from the start
    Waypoint waypoint;
  };

  std::vector<Stop> stops_;
  bool loop_;
};

}  // namespace incision
