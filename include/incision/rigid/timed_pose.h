#pragma once

#include <vector>

#include "incision/rigid/pose.h"

namespace incision {

class YamlValue;

struct TimedPose {
  double time = 0;  ///< [s]
  Pose pose;
};

/// A list of [t, x, y, z, qx, qy, qz, qw] in ascending times. Throws InputError.
std::vector<TimedPose> parsePoses(const YamlValue& value);

}  // namespace incision
