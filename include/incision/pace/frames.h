#pragma once

#include <optional>
#include <string>
#include <utility>

#include "incision/pace/command.h"
#include "incision/rigid/pose.h"

namespace incision {

struct StampedPose {
  Pose pose;
  Nanoseconds stamp;  ///< 0: it holds for all times
};

/// Where named frames stand in the body's frame. To ask never waits.
class Frames {
 public:
  explicit Frames(std::string body) : body_(std::move(body)) {}
  virtual ~Frames() = default;

  /// Name of the body's frame.
  const std::string& body() const { return body_; }

  /// Whether anything has been heard of this frame.
  virtual bool knows(const std::string& frame) const = 0;

  /// Where the frame stood at this time; 0: at last. Where that is not known, nothing, and the reason in `why_not`
  /// unless that is null or none is known.
  virtual std::optional<StampedPose> find(const std::string& frame, Nanoseconds time, std::string* why_not) const = 0;

 private:
  const std::string body_;
};

}  // namespace incision
