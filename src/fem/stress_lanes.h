#pragma once

#include <array>

#include "incision/fem/assembly.h"
#include "lanes.h"

namespace incision {

/// V σ [N m] of up to LANES parts in their unrotated frames, with what it is made of.
struct Assembly::StressLanes {
  std::array<int, LANES> at;  ///< the parts; the last one fills up the lanes
  LaneMatrix b, R, stress;    ///< b has the gradients b_1, b_2, b_3 as columns
};

}  // namespace incision
