#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>

#include "incision/body/deformable_body.h"
#include "incision/pace/answers.h"
#include "incision/pace/jaw_tracker.h"
#include "incision/pace/link_lookup.h"
#include "incision/pace/step_time.h"
#include "incision/pace/tool_tracker.h"

namespace incision {

/// What of a ToolGuide outlasts a step.
struct ToolGuideMemory {
  ToolTrackerMemory tracker;
  JawTrackerMemory jaw;
  std::optional<Nanoseconds> frame_stamp;
  bool active = true;  ///< as it was told last
};

template <class Archive>
void serialize(Archive& archive, ToolGuideMemory& memory) {
  auto& [tracker, jaw, frame_stamp, active] = memory;
  archive(tracker, jaw, frame_stamp, active);
}

void check(const ToolGuideMemory& memory, const MemoryLimits& limits);

/// Leads one of the body's tools along its poses, which come in messages or from its frame. Used by the stepping
/// thread.
class ToolGuide {
 public:
  /// `tool`: its index in the scene. `answers` are told of strokes that end.
  ToolGuide(std::size_t tool, const Scene& scene, const ToolForm& form, const Frames& frames, Answers& answers);

  /// Before a step: the tool goes where the poses have it.
  void lead(ToolInput input, const StepTime& time, DeformableBody* body);

  ToolGuideMemory keep() const { return {tracker_.keep(), jaw_.keep(), frame_stamp_, told_active_}; }
  void recall(ToolGuideMemory memory) noexcept;
  /// Goes on with a tool that stands there, if it is in place, and that nobody led.
  void takeOver(const std::optional<Pose>& pose) noexcept;

  /// Whether it does what it is for, after the last step.
  bool active() const { return active_; }
  /// As ToolTracker explains.
  bool stale() const { return tracker_.stale(); }
  std::uint64_t jumps() const { return tracker_.jumps(); }
  /// Receipt of the newest pose that the last step was the first to follow.
  const std::optional<SteadyTime>& received() const { return received_; }
  /// Transforms of its frame that were of no use, so far.
  std::uint64_t ignored() const { return lookup_.ignored(); }

 private:
  void addFrame(const StepTime& time, ToolInput* input);
  void tell(const ToolMove& move) const;

  const std::size_t tool_;
  const ToolSettings settings_;
  Answers& answers_;
  LinkLookup lookup_;
  std::optional<Nanoseconds> frame_stamp_;
  ToolTracker tracker_;
  JawTracker jaw_;
  bool active_ = true, told_active_ = true;
  std::optional<SteadyTime> received_;
};

}  // namespace incision
