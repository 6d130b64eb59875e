#pragma once

#include <string>
#include <vector>

#include "incision/contact/obstacles.h"
#include "incision/pace/approach.h"
#include "incision/ros/link_lookup.h"

namespace incision {

/// A link that is further from where it stood than this speed [m/s] explains did not move there but was put there: it
/// sweeps nothing on its way. No robot's hand is faster; slower jumps would throw the body about.
inline constexpr double MAX_OBSTACLE_SPEED = 10;

/// Where a link goes in the next step.
struct LinkMove {
  int link;
  Pose pose;     ///< in the body's frame, at the end of the step
  bool at_once;  ///< it is put there, and sweeps nothing on its way
};

/// Follows the obstacles' links in tf, by their names. A link that tf does not know stays where it is, and the tool's
/// is left alone. Used by the stepping thread, which it never makes wait.
class ObstacleTracker {
 public:
  /// `time_step` [s].
  ObstacleTracker(const tf2::BufferCore& buffer, std::string body_frame, const Obstacles& obstacles, double time_step);

  /// The links that go somewhere in the next step. They follow their transforms at `end`, the ROS time at which the
  /// step ends; where tf does not know those yet, or `end` is 0, the latest.
  std::vector<LinkMove> follow(Nanoseconds end);

  /// Each link is where the description has it, until tf says otherwise.
  void restart();

  /// Where the links are, or are going in the step asked for last.
  const std::vector<Pose>& poses() const { return poses_; }

  /// Links left where they were, so far, because their transform was of no use.
  std::uint64_t ignored() const { return lookup_.ignored(); }

 private:
  struct Link {
    std::string name;
    Pose described;
    double reach = 0;  ///< [m] of its shapes from its origin
    Pose target;
    Nanoseconds stamp = 0;  ///< of the target
    Approach approach;      ///< to the target
    bool found = false;     ///< in tf
  };
  bool aim(const LinkLookup::Found& target, const Pose& pose, Link* link) const;

  LinkLookup lookup_;
  const int tool_link_;
  const double time_step_;
  std::vector<Link> links_;
  std::vector<Pose> poses_;
};

}  // namespace incision
