#pragma once

#include <map>
#include <set>
#include <string>

#include "incision/pace/frames.h"

namespace incision {

/// Frames that know what a test has told them: poses at times, between which nothing is known.
class FramesInTests : public Frames {
 public:
  FramesInTests() : Frames("body") {}

  void set(const std::string& frame, Nanoseconds time, const Pose& pose) { poses_[frame][time] = pose; }
  /// Somebody has spoken of this frame, but it is not connected with the body's.
  void mention(const std::string& frame) { mentioned_.insert(frame); }

  bool knows(const std::string& frame) const override { return poses_.count(frame) + mentioned_.count(frame) > 0; }

  std::optional<StampedPose> find(const std::string& frame, Nanoseconds time, std::string* why_not) const override {
    const auto poses = poses_.find(frame);
    if (poses != poses_.end()) {
      const auto found = time == 0 ? std::prev(poses->second.end()) : poses->second.find(time);
      if (found != poses->second.end()) return StampedPose{found->second, found->first};
    }
    if (why_not != nullptr) *why_not = "nobody has told";
    return std::nullopt;
  }

 private:
  std::map<std::string, std::map<Nanoseconds, Pose>> poses_;
  std::set<std::string> mentioned_;
};

}  // namespace incision
