#include "incision/ros/demo/scalpel.h"

#include <ros/console.h>
#include <sensor_msgs/JointState.h>
#include <std_msgs/Bool.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <thread>

#include "incision/base/input_error.h"
#include "incision/base/limits.h"
#include "incision/ros/conversions.h"
#include "incision/ros/private_parameters.h"

namespace incision {
namespace {

/// Poses that are late by up to this [s], because the machine was busy, are made up for. What is later is a jump of the
/// clock, or a process that was stopped, and the path goes on from where it was.
constexpr double MAX_LATE = 1;

/// [s] far more than a demo or a test takes.
constexpr double MAX_LEG_TIME = 1e6;

/// Between two looks at the clock [s]: quicker would be a busy loop, slower would not notice the end of ROS.
constexpr double MIN_SLEEP = 0.001, MAX_SLEEP = 0.1;

/// Share of a period by which rounding may put a look at the clock before the pose that is due then.
constexpr double ROUNDING = 1e-6;

/// One number for each of `count`, or nothing where the key is absent.
std::vector<double> loadNumbers(const YamlMap& parameters, const std::string& key, std::size_t count,
                                const Range& range) {
  std::vector<double> numbers;
  if (const auto value = parameters.find(key))
    for (const YamlValue& number : value->list(count)) numbers.push_back(number.number(range));
  return numbers;
}

/// A leg without a length takes its time from ~leg_times, the one back to the first waypoint of a loop too.
std::vector<Waypoint> loadPath(const YamlMap& parameters, bool loop) {
  const YamlValue value = parameters.at("path");
  const std::vector<YamlValue> poses = value.list();
  if (poses.empty()) value.refuse("one waypoint [x, y, z, roll, pitch, yaw] or more");
  const std::size_t count = poses.size();
  const std::vector<double> angles = loadNumbers(parameters, "jaw", count, {-MAX_COORDINATE, MAX_COORDINATE});
  const std::vector<double> times = loadNumbers(parameters, "leg_times", loop ? count : count - 1, {0, MAX_LEG_TIME});
  std::vector<Waypoint> path(count);
  for (std::size_t i = 0; i < count; ++i) {
    path[i].place = {toPose(poses[i]), angles.empty() ? 0 : angles[i]};
    if (i < times.size()) path[i].leg_time = times[i];
    if (i > 0 && path[i - 1].place.pose.position == path[i].place.pose.position && path[i - 1].leg_time == 0)
      poses[i].fail(
          "at the position of the waypoint before it (allowed: another position, for the speed to hold, or a time in "
          "leg_times)");
  }
  return path;
}

/// Messages that may wait for a slow subscriber.
std::uint32_t queueOf(const ScalpelSettings& settings) {
  return static_cast<std::uint32_t>(MAX_LATE * settings.rate) + 1;
}

}  // namespace

ScalpelSettings loadScalpelSettings(const ros::NodeHandle& node) {
  const YamlMap parameters =
      privateParameters(node, {"frame", "tool_frame", "path", "jaw", "leg_times", "speed", "rate", "loop"});
  ScalpelSettings settings;
  settings.frame = frameParameter(parameters, "frame", settings.frame);
  settings.tool_frame = frameParameter(parameters, "tool_frame", settings.tool_frame);
  settings.speed = parameters.number("speed", settings.speed, {ABOVE_ZERO, 100});
  settings.rate = parameters.number("rate", settings.rate, {1, 20000});
  if (const auto loop = parameters.find("loop")) settings.loop = loop->boolean();
  settings.path = loadPath(parameters, settings.loop);
  settings.has_jaw = parameters.has("jaw");
  return settings;
}

Scalpel::Scalpel(ros::NodeHandle& node, const ScalpelSettings& settings)
    : settings_(settings),
      path_(settings.path, settings.speed, settings.loop),
      publisher_(node, settings.tool_frame, queueOf(settings)),
      done_publisher_(node.advertise<std_msgs::Bool>("done", 1, true)) {
  if (settings.has_jaw) jaw_publisher_ = node.advertise<sensor_msgs::JointState>("jaw", queueOf(settings));
  publishDone(false);
}

void Scalpel::run() {
  using Clock = std::chrono::steady_clock;
  const std::chrono::duration<double> sleep(std::clamp(1 / settings_.rate, MIN_SLEEP, MAX_SLEEP));
  const auto period = std::chrono::duration_cast<Clock::duration>(sleep);
  for (auto wake = Clock::now(); ros::ok(); wake = std::max(wake + period, Clock::now())) {
    std::this_thread::sleep_until(wake);
    publishDue(static_cast<Nanoseconds>(ros::Time::now().toNSec()));
  }
}

/// Pose k is due k / rate after the start.
void Scalpel::publishDue(Nanoseconds now) {
  if (now == 0) return;  // /clock has not begun
  if (!start_) {
    if (!publisher_.hasSubscribers() || (jaw_publisher_ && jaw_publisher_.getNumSubscribers() == 0)) return;
    start_ = now;
  }
  const auto due = [&] {
    return 1 +
           static_cast<std::int64_t>(std::floor(1e-9 * static_cast<double>(now - *start_) * settings_.rate + ROUNDING));
  };
  const double late = static_cast<double>(due() - count_) / settings_.rate;
  if (late < 0 || late > MAX_LATE) start_ = now - afterStart(count_);
  while (count_ < due()) publishNext();
}

Nanoseconds Scalpel::afterStart(std::int64_t pose) const {
  return std::llround(1e9 * static_cast<double>(pose) / settings_.rate);
}

void Scalpel::publishNext() {
  const Nanoseconds time = afterStart(count_++);
  const double seconds = 1e-9 * static_cast<double>(time);
  geometry_msgs::PoseStamped message;
  message.header.frame_id = settings_.frame;
  message.header.stamp = toRos(*start_ + time);
  const ToolPlace place = path_.at(seconds);
  message.pose = toPoseMessage(place.pose);
  publisher_.publish(message);
  if (jaw_publisher_) publishJaw(place.jaw, message.header.stamp);
  if (!done_ && seconds >= path_.duration()) publishDone(true);
}

void Scalpel::publishJaw(double angle, const ros::Time& stamp) {
  sensor_msgs::JointState message;  // without a name: a tool has one jaw
  message.header.stamp = stamp;
  message.position = {angle};
  jaw_publisher_.publish(message);
}

void Scalpel::publishDone(bool done) {
  done_ = done;
  std_msgs::Bool message;
  message.data = done;
  done_publisher_.publish(message);
  if (done) ROS_INFO_STREAM("the path of " << publisher_.topic() << " is through; the tool stays at its end");
}

}  // namespace incision
