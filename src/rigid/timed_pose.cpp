#include "incision/rigid/timed_pose.h"

#include <algorithm>
#include <cctype>
#include <cmath>

#include "incision/base/line_reader.h"
#include "incision/base/printable.h"
#include "incision/base/read_text.h"
#include "incision/base/yaml_reader.h"

namespace incision {

namespace {

/// Bytes of the largest file of poses: some ten minutes of a thousand poses a second.
constexpr std::size_t MAX_POSES_FILE = std::size_t{1} << 26;

constexpr const char* COLUMNS[] = {"t", "x", "y", "z", "qx", "qy", "qz", "qw"};

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

TimedPose readPose(LineReader* reader) {
  std::array<double, 8> numbers;
  for (std::size_t i = 0; i < numbers.size(); ++i) numbers[i] = reader->real(COLUMNS[i]);
  reader->endOfLine();
  return poseOf([&](std::size_t i) { return numbers[i]; }, [&](const std::string& reason) { reader->fail(reason); });
}

constexpr const char* NOT_LATER = "not later than the pose before it (allowed: ascending times)";

}  // namespace

bool operator==(const TimedPose& a, const TimedPose& b) { return a.time == b.time && a.pose == b.pose; }

std::vector<TimedPose> parsePoses(const YamlValue& value) {
  std::vector<TimedPose> poses;
  for (const YamlValue& entry : value.list()) {
    const TimedPose timed = parsePose(entry);
    if (!poses.empty() && timed.time <= poses.back().time) entry.fail(NOT_LATER);
    poses.push_back(timed);
  }
  return poses;
}

void parsePosesOf(const YamlMap& map, std::vector<TimedPose>* poses, std::string* file) {
  if (map.has("poses") && map.has("poses_file")) map.at("poses_file").fail("beside poses (allowed: one of the two)");
  if (const auto given = map.find("poses")) *poses = parsePoses(*given);
  if (const auto path = map.find("poses_file")) *file = path->path();
}

std::vector<TimedPose> readPoses(const std::string& path) {
  std::string text = readText(path, MAX_POSES_FILE);
  std::replace(text.begin(), text.end(), ',', ' ');
  LineReader reader(text, printable(path));
  std::vector<TimedPose> poses;
  while (reader.next()) {
    if (reader.line() == 1 && std::isalpha(static_cast<unsigned char>(reader.rest().front()))) continue;
    const TimedPose timed = readPose(&reader);
    if (!poses.empty() && timed.time <= poses.back().time) reader.fail(NOT_LATER);
    if (timed.time < SIMULATED_TIME.min) reader.fail("t: " + std::to_string(timed.time) + " (allowed: 0 or more)");
    poses.push_back(timed);
  }
  if (poses.empty()) reader.fail("no poses (allowed: lines of t, x, y, z, qx, qy, qz, qw)");
  if (poses.back().time <= SIMULATED_TIME.max) return poses;
  const double first = poses.front().time;
  for (TimedPose& timed : poses) timed.time -= first;
  if (poses.back().time > SIMULATED_TIME.max) reader.fail("t: more than 1e9 s after the first");
  return poses;
}

Pose poseAt(const std::vector<TimedPose>& poses, double time) {
  const auto after =
      std::lower_bound(poses.begin(), poses.end(), time, [](const TimedPose& pose, double t) { return pose.time < t; });
  if (after == poses.begin()) return poses.front().pose;
  if (after == poses.end()) return poses.back().pose;
  const auto previous = after - 1;
  return between(previous->pose, after->pose, (time - previous->time) / (after->time - previous->time));
}

}  // namespace incision
