#include "incision/rigid/timed_pose.h"

#include <cmath>

#include "incision/base/yaml_reader.h"

namespace incision {

namespace {

TimedPose parsePose(const YamlValue& value) {
  const std::vector<YamlValue> entries = value.list(8);
  const auto at = [&](int i) { return entries[static_cast<std::size_t>(i)].number(); };
  TimedPose timed;
  timed.time = entries[0].number(SIMULATED_TIME);
  timed.pose.position = Vec3(at(1), at(2), at(3));
  timed.pose.orientation = Eigen::Quaterniond(at(7), at(4), at(5), at(6));
  const double length = timed.pose.orientation.norm();
  if (!(std::abs(length - 1) <= QUATERNION_TOLERANCE)) {
    value.fail("a quaternion of length " + std::to_string(length) +
               " (allowed: [t, x, y, z, qx, qy, qz, qw], length 1)");
  }
  timed.pose.orientation.normalize();
  return timed;
}

}  // namespace

std::vector<TimedPose> parsePoses(const YamlValue& value) {
  std::vector<TimedPose> poses;
  for (const YamlValue& entry : value.list()) {
    const TimedPose timed = parsePose(entry);
    if (!poses.empty() && timed.time <= poses.back().time) {
      entry.fail("not later than the pose before it (allowed: ascending times)");
    }
    poses.push_back(timed);
  }
  return poses;
}

}  // namespace incision
