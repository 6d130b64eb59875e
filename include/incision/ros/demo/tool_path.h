#pragma once

#include <vector>

#include "incision/tool/settings.h"

namespace incision {

/// A way along straight legs from one waypoint to the next, at an even speed; on each leg the tool turns evenly.
class ToolPath {
 public:
  /// `waypoints`: one or more, no two neighbours at the same position. `speed` [m/s] above 0. With `loop` the way leads
  /// from the last one back to the first, and so on.
  ToolPath(const std::vector<Pose>& waypoints, double speed, bool loop);

  /// Where the tool is after `time` [s], 0 or more. At the end it stays.
  Pose at(double time) const;

  /// [s] from the start until it stays for good; infinite for a loop of more than one waypoint.
  double duration() const;

 private:
  std::vector<TimedPose> waypoints_;
  bool loop_;
};

}  // namespace incision
