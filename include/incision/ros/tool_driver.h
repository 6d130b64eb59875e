#pragma once

#include <incision/ToolState.h>
#include <ros/node_handle.h>

#include <optional>
#include <string>
#include <vector>

#include "incision/body/deformable_body.h"
#include "incision/pace/jaw_tracker.h"
#include "incision/pace/link_lookup.h"
#include "incision/pace/tool_tracker.h"

namespace incision {

/// When a step takes place.
struct StepTime {
  Nanoseconds start;    ///< on the steady clock; with use_sim_time, ROS time
  Nanoseconds end;      ///< ROS time; 0: not known
  Nanoseconds ros;      ///< ROS time at the start
  bool single = false;  ///< of a paused body
};

/// What of a ToolDriver outlasts a step.
struct ToolDriverMemory {
  ToolTrackerMemory tracker;
  JawTrackerMemory jaw;
  std::optional<Nanoseconds> frame_stamp;
  bool active = true;  ///< as it was told last
};

template <class Archive>
void serialize(Archive& archive, ToolDriverMemory& memory) {
  auto& [tracker, jaw, frame_stamp, active] = memory;
  archive(tracker, jaw, frame_stamp, active);
}

void check(const ToolDriverMemory& memory, const MemoryLimits& limits);

/// Leads one of the body's tools along its poses, which come in messages or from tf, and publishes, in the words of
/// the collaborative robotics toolkit, where it is (`measured_cp`, `jaw/measured_js`) and what it feels
/// (`measured_cf`): force and torque of the tissue on the tool, the torque about the origin of the tool's link, both in
/// the frame of that link. A tool that presses down on tissue is pushed up. Used by the stepping thread.
class ToolDriver {
 public:
  /// `tool`: its index in the scene.
  ToolDriver(ros::NodeHandle& node, std::size_t tool, const Scene& scene, const ToolForm& form, const Frames& frames);

  /// Before a step: the tool goes where the poses have it. Returns the strokes that ended with that.
  std::vector<CutResult> lead(ToolInput input, const StepTime& time, DeformableBody* body);

  /// Right after a step: where the tool is and what it feels, while it is in place. What it feels has a stamp of zero
  /// where it is not valid: once when its pose has gone stale, or when it has been taken away, and none until a pose
  /// comes.
  void publish(const StepResult& step, const DeformableBody& body);

  /// Before a reset of the body: takes the tool away until the next pose. Returns the stroke that ended with that.
  std::optional<CutResult> restart(DeformableBody* body);

  ToolDriverMemory keep() const { return {tracker_.keep(), jaw_.keep(), frame_stamp_, told_active_}; }
  void recall(const ToolDriverMemory& memory);
  /// Goes on with a tool that stands there, if it is in place, and that nobody led.
  void takeOver(const std::optional<Pose>& pose);

  /// What is known of the tool, but for the messages refused.
  ToolState state(const StepResult& step, const DeformableBody& body) const;

  /// Transforms of its frame that were of no use, so far.
  std::uint64_t ignored() const { return lookup_.ignored(); }

 private:
  const ToolReport& reportIn(const StepResult& step) const;
  void addFrame(const StepTime& time, ToolInput* input);
  void log(const ToolMove& move) const;
  void publishPose(const Pose& pose, const ros::Time& stamp);
  void publishJaw(const ToolReport& report, const ros::Time& stamp);
  void publishWrench(const ToolReport& report, const ros::Time& stamp);

  const std::size_t tool_;
  const ToolSettings settings_;
  const std::string body_frame_, wrench_frame_;
  LinkLookup lookup_;
  std::optional<Nanoseconds> frame_stamp_;
  ToolTracker tracker_;
  JawTracker jaw_;
  bool active_ = true, told_active_ = true;
  bool valid_ = false;                  ///< the last wrench was
  std::optional<SteadyTime> received_;  ///< newest pose that the last step was the first to follow
  double latency_ = 0;                  ///< [s]
  ros::Publisher pose_publisher_, wrench_publisher_, jaw_publisher_;
};

}  // namespace incision
