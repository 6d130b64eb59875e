#pragma once

#include <vector>

#include "incision/base/memory_limits.h"
#include "incision/base/vec.h"

namespace incision {

/// Positions and velocities of all copies.
struct Motion {
  std::vector<Vec3> x;  ///< [m]
  std::vector<Vec3> v;  ///< [m/s]
};

template <class Archive>
void serialize(Archive& archive, Motion& motion) {
  auto& [x, v] = motion;
  archive(x, v);
}

void check(const Motion& motion, const MemoryLimits& limits);

}  // namespace incision
