#include "incision/ros/tf_frames.h"

#include <ros/console.h>

#include "incision/ros/conversions.h"

namespace incision {
namespace {

/// Least time [s] between two warnings.
constexpr double WARNING_PERIOD = 2;

}  // namespace

TfFrames::TfFrames(const tf2::BufferCore& buffer, const std::string& body_frame)
    : Frames(body_frame), buffer_(buffer) {}

bool TfFrames::knows(const std::string& frame) const { return buffer_._frameExists(frame); }

std::optional<StampedPose> TfFrames::find(const std::string& frame, Nanoseconds time, std::string* why_not) const {
  try {
    if (!buffer_.canTransform(body(), frame, toRos(time), why_not)) return std::nullopt;
    const auto found = buffer_.lookupTransform(body(), frame, toRos(time));
    return StampedPose{toPose(found.transform), static_cast<Nanoseconds>(found.header.stamp.toNSec())};
  } catch (const std::exception& error) {  // tf changed meanwhile, or a stamp is too far off to subtract
    if (why_not != nullptr) *why_not = error.what();
    return std::nullopt;
  }
}

LinkLookup::Complain warnOfLinks(const std::string& owner) {
  return [owner](const std::string& link, const std::string& why) {
    ROS_WARN_STREAM_THROTTLE(WARNING_PERIOD, "link \"" << link << "\" of " << owner << " stays where it is: " << why);
  };
}

}  // namespace incision
