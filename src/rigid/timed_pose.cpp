#include "incision/rigid/timed_pose.h"

#include <cmath>

#include "timed_series.h"

namespace incision {

namespace {

/// The pose of the eight numbers that `at(i)` gives; `fail(reason)` refuses them.
template <class At, class Fail>
TimedPose poseOf(const At& at, const Fail& fail) {
  TimedPose timed;
  timed.time = at(0);
  timed.pose.position = Vec3(at(1), at(2), at(3));
  timed.pose.orientation = Eigen::Quaterniond(at(7), at(4), at(5), at(6));
  const double length = timed.pose.orientation.norm();
  if (!(std::abs(length - 1) <= QUATERNION_TOLERANCE)) {
    fail("a quaternion of length " + std::to_string(length) + " (allowed: [t, x, y, z, qx, qy, qz, qw], length 1)");
  }
  timed.pose.orientation.normalize();
  return timed;
}

TimedPose parsePose(const YamlValue& value) {
  const std::vector<YamlValue> entries = value.list(8);
  const auto at = [&](std::size_t i) { return i == 0 ? entries[0].number(SIMULATED_TIME) : entries[i].number(); };
  return poseOf(at, [&](const std::string& reason) { value.fail(reason); });
}

}  // namespace

bool operator==(const TimedPose& a, const TimedPose& b) { return a.time == b.time && a.pose == b.pose; }

std::vector<TimedPose> parsePoses(const YamlValue& value) { return parseSeries<TimedPose>(value, parsePose); }

void parsePosesOf(const YamlMap& map, std::vector<TimedPose>* poses, std::string* file) {
  parseSeriesOf(map, "poses", parsePoses, poses, file);
}

std::vector<TimedPose> readPoses(const std::string& path) {
  const std::array<const char*, 8> columns = {"t", "x", "y", "z", "qx", "qy", "qz", "qw"};
  return readSeries<TimedPose>(path, columns, [](const std::array<double, 8>& numbers, const auto& fail) {
    return poseOf([&](std::size_t i) { return numbers[i]; }, fail);
  });
}

Pose poseAt(const std::vector<TimedPose>& poses, double time) {
  return seriesAt(poses, time, [](const TimedPose& before, const TimedPose& after, double share) {
    return share == 0 ? before.pose : between(before.pose, after.pose, share);
  });
}

}  // namespace incision
