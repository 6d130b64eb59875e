#pragma once

#include "incision/pace/command.h"

namespace incision {

/// When a step takes place.
struct StepTime {
  Nanoseconds start;    ///< on the steady clock; with use_sim_time, ROS time
  Nanoseconds end;      ///< ROS time; 0: not known
  Nanoseconds ros;      ///< ROS time at the start
  bool single = false;  ///< of a paused body
};

}  // namespace incision
