#include "incision/ros/tf_frames.h"

#include "incision/ros/conversions.h"

namespace incision {

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

}  // namespace incision
