#include "incision/ros/link_lookup.h"

#include <ros/console.h>

#include <cmath>

#include "incision/ros/conversions.h"
#include "incision/ros/validation.h"

namespace incision {
namespace {

/// Least time [s] between two warnings.
constexpr double WARNING_PERIOD = 2;

bool isUsable(const Pose& pose) {
  return pose.position.allFinite() && pose.position.cwiseAbs().maxCoeff() <= MAX_POSITION &&
         std::abs(pose.orientation.norm() - 1) <= QUATERNION_TOLERANCE;
}

}  // namespace

LinkLookup::LinkLookup(const tf2::BufferCore& buffer, std::string body_frame, std::string whose)
    : buffer_(buffer), body_frame_(std::move(body_frame)), whose_(std::move(whose)) {}

std::optional<LinkLookup::Found> LinkLookup::find(const std::string& link, Nanoseconds end) {
  if (link == body_frame_ || !buffer_._frameExists(link)) return std::nullopt;
  try {
    const bool known = end > 0 && buffer_.canTransform(body_frame_, link, toRos(end));
    if (known || buffer_.canTransform(body_frame_, link, ros::Time())) {
      const auto found = buffer_.lookupTransform(body_frame_, link, known ? toRos(end) : ros::Time());
      const Pose pose = toPose(found.transform);
      if (isUsable(pose)) return Found{pose, static_cast<Nanoseconds>(found.header.stamp.toNSec())};
      ignore(link, "its transform is not finite, or further than 1e9 m");
    } else {
      ignore(link, "tf knows it, but not where it is in \"" + body_frame_ + "\"");
    }
  } catch (const std::exception& error) {  // tf changed meanwhile, or a stamp is too far off to subtract
    ignore(link, error.what());
  }
  return std::nullopt;
}

void LinkLookup::ignore(const std::string& link, const std::string& why) {
  ++ignored_;
  ROS_WARN_STREAM_THROTTLE(WARNING_PERIOD, "link \"" << link << "\" of " << whose_ << " stays where it is: " << why);
}

}  // namespace incision
