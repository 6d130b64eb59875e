#pragma once

#include <incision/BodyState.h>
#include <ros/node_handle.h>

#include <optional>
#include <string>
#include <vector>

#include "incision/body/deformable_body.h"
#include "incision/pace/link_lookup.h"
#include "incision/pace/tool_tracker.h"
#include "incision/ros/tool_entry.h"

namespace incision {

/// When a step takes place.
struct StepTime {
  Nanoseconds start;    ///< on the steady clock; with use_sim_time, ROS time
  Nanoseconds end;      ///< ROS time; 0: not known
  bool single = false;  ///< of a paused body
};

/// Leads one of the body's tools along its poses, which come in messages or from tf, and publishes the wrench: force
/// and torque of the tissue on the tool, the torque about the origin of the tool's link, both in the frame of that
/// link. A tool that presses down on tissue is pushed up. Used by the stepping thread.
class ToolDriver {
 public:
  /// `tool`: its index.
  ToolDriver(ros::NodeHandle& node, std::size_t tool, const ToolEntry& entry, const Edge& edge, const Frames& frames,
             double time_step);

  /// Before a step: the tool goes where the poses have it. Returns the strokes that ended with that.
  std::vector<CutResult> lead(ToolInput input, const StepTime& time, DeformableBody* body);

  /// Right after a step. While the tool touches, one wrench a step; then one of zero, so that nobody keeps the last
  /// one. When the tool's pose has gone stale, one of zero with stamp zero, and none until a pose comes.
  void publishWrench(const StepResult& step);

  /// Before a reset of the body: takes the tool away until the next pose. Returns the stroke that ended with that.
  std::optional<CutResult> restart(DeformableBody* body);

  /// Adds the tool to the state, which has room for one: of several it tells sums, the largest values, and whether
  /// something holds of any.
  void addTo(const StepResult& step, BodyState* state) const;

 private:
  const ToolReport& reportIn(const StepResult& step) const;
  void addFrame(const StepTime& time, ToolInput* input);
  void log(const ToolMove& move) const;
  void publishWrench(const ToolReport& report);
  void publish(const ros::Time& stamp, const Vec3& force, const Vec3& torque);

  const std::size_t tool_;
  const ToolSettings settings_;
  const std::string wrench_frame_;
  LinkLookup lookup_;
  std::optional<Nanoseconds> frame_stamp_;
  ToolTracker tracker_;
  bool active_ = true;
  bool pressed_ = false;  ///< the last wrench was not a zero
  bool said_stale_ = false;
  std::optional<SteadyTime> received_;  ///< newest pose that the last step was the first to follow
  double latency_ = 0;                  ///< [s]
  ros::Publisher publisher_;
};

}  // namespace incision
