#pragma once

#include <tf2/buffer_core.h>

#include <string>

#include "incision/pace/frames.h"

namespace incision {

/// Frames as tf knows them. Thread-safe.
class TfFrames : public Frames {
 public:
  TfFrames(const tf2::BufferCore& buffer, const std::string& body_frame);

  bool knows(const std::string& frame) const override;
  std::optional<StampedPose> find(const std::string& frame, Nanoseconds time, std::string* why_not) const override;

 private:
  const tf2::BufferCore& buffer_;
};

}  // namespace incision
