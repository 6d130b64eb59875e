#pragma once

#include <vector>

#include "incision/rigid/rigid_motion.h"
#include "incision/solver/coupler.h"

namespace incision {

/// A tool in the body's whole step that is being taken, for what couples it to the body.
struct ToolInStep {
  bool in_place = false;  ///< it has a pose; without, it is not there
  bool active = true;     ///< it does what its kind does; otherwise it only touches
  /// Of all that moves together, in the body's frame: the first is that of its link, the others those of jaws.
  std::vector<RigidMotion> groups;
  double jaw_from = 0, jaw_to = 0;  ///< angle of its joint when the step starts and ends [rad]
  /// What the body has done to each of these groups so far, on the mean of the whole step, about the origin of the
  /// body's frame.
  std::vector<Wrench> felt;

  /// Adds what a group has felt in a part of the step.
  void feel(int group, const StepSpan& span, const Wrench& wrench) {
    felt[static_cast<std::size_t>(group)] += (span.to - span.from) * wrench;
  }
};

}  // namespace incision
