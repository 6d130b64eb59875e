#pragma once

#include <vector>

#include "incision/contact/obstacles.h"
#include "incision/rigid/rigid_motion.h"

namespace incision {

/// Where the links of a body's obstacles go.
class ObstacleMotions {
 public:
  explicit ObstacleMotions(const Obstacles& obstacles) {
    for (const ObstacleLink& link : obstacles.links) motions_.push_back({link.pose, link.pose});
  }

  /// In the next step the link moves evenly to the pose, where it stays. Throws std::out_of_range without such a link.
  void move(int link, const Pose& pose) { motions_.at(static_cast<std::size_t>(link)).to = pose; }
  /// The link is put there, and sweeps nothing on its way.
  void place(int link, const Pose& pose) { motions_.at(static_cast<std::size_t>(link)) = {pose, pose}; }

  /// The step has been taken.
  void endStep() {
    for (RigidMotion& motion : motions_) motion.from = motion.to;
  }

  /// Of each link, in the step to come. All of it outlasts a step.
  const std::vector<RigidMotion>& inStep() const { return motions_; }
  void recall(const std::vector<RigidMotion>& motions) { motions_ = motions; }

 private:
  std::vector<RigidMotion> motions_;
};

}  // namespace incision
