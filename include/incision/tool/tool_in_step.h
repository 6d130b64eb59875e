#pragma once

#include "incision/rigid/rigid_motion.h"
#include "incision/solver/coupler.h"

namespace incision {

/// A tool in the body's whole step that is being taken, for what couples it to the body.
struct ToolInStep {
  bool in_place = false;  ///< it has a pose; without, it is not there
  bool active = true;     ///< it does what its kind does; otherwise it only touches
  RigidMotion motion;     ///< of its link, in the body's frame
  /// What the body has done to it so far, on the mean of the whole step, about the origin of the body's frame.
  Wrench felt;

  /// Adds what it has felt in a part of the step.
  void feel(const StepSpan& span, const Wrench& wrench) {
    felt.force += (span.to - span.from) * wrench.force;
    felt.torque += (span.to - span.from) * wrench.torque;
  }
};

}  // namespace incision
