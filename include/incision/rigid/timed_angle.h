#pragma once

#include <string>
#include <vector>

namespace incision {

class YamlMap;

/// Where a joint is at a time.
struct TimedAngle {
  double time = 0;   ///< [s]
  double angle = 0;  ///< [rad], of a prismatic joint [m]
};

/// The keys `jaw`, a list of [t, angle] in ascending times, and `jaw_file` of a map, which has one of them or none. The
/// file is still to be read then. Throws InputError.
void parseAnglesOf(const YamlMap& map, std::vector<TimedAngle>* angles, std::string* file);

/// The angles of a CSV file with the columns t, angle, as readPoses reads poses. Throws InputError.
std::vector<TimedAngle> readAngles(const std::string& path);

/// The angle at a time [s], interpolated; before the first and after the last it is that one. There must be one.
double angleAt(const std::vector<TimedAngle>& angles, double time);

}  // namespace incision
