#pragma once

#include <string>
#include <vector>

#include "incision/rigid/pose.h"

namespace incision {

class YamlMap;
class YamlValue;

struct TimedPose {
  double time = 0;  ///< [s]
  Pose pose;
};

/// Whether they are the same numbers.
bool operator==(const TimedPose& a, const TimedPose& b);

/// A list of [t, x, y, z, qx, qy, qz, qw] in ascending times. Throws InputError.
std::vector<TimedPose> parsePoses(const YamlValue& value);

/// The keys `poses` and `poses_file` of a map, which has one of them or none. The file is still to be read then.
void parsePosesOf(const YamlMap& map, std::vector<TimedPose>* poses, std::string* file);

/// The poses of a CSV file with the columns t, x, y, z, qx, qy, qz, qw, in ascending times; a first line that begins
/// with a letter is a heading. Times beyond those that are simulated, as those since 1970, count from the first. Throws
/// InputError.
std::vector<TimedPose> readPoses(const std::string& path);

/// The pose at a time [s], interpolated; before the first and after the last it is that one. There must be one.
Pose poseAt(const std::vector<TimedPose>& poses, double time);

}  // namespace incision
