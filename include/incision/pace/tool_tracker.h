#pragma once

#include <optional>
#include <vector>

#include "incision/pace/approach.h"
#include "incision/pace/tool_queue.h"
#include "incision/tool/settings.h"

namespace incision {

/// Most strokes, or parts of them with the blade on and off, that wait for steps of their own. No hand begins more in
/// the time of one step; of a publisher that jumps about, the tool then skips the oldest.
inline constexpr int MAX_WAITING_STROKES = 8;

/// What the tool does in the next step, in this order.
struct ToolMove {
  bool active = true;                  ///< the blade is on
  std::optional<Pose> placed;          ///< it is put there, and sweeps nothing on its way
  std::vector<Pose> path;              ///< it goes evenly along these poses
  std::optional<SteadyTime> received;  ///< of the newest pose that it follows for the first time

  // What somebody should be told.
  std::optional<double> jump;  ///< [m] from one pose to the next, where a new stroke begins because that is too far
  bool went_stale = false;     ///< as ToolTracker::stale() explains
  bool came_again = false;     ///< poses, after they had gone stale
};

/// What of a ToolTracker outlasts a step.
struct ToolTrackerMemory {
  std::vector<ReceivedPose> waiting;  ///< their times less that of the step asked for last, so never above 0
  std::optional<Pose> last;           ///< newest pose that is on the way
  bool active = true;                 ///< the blade is on on the way to it
  Nanoseconds age = 0;                ///< of it, at the step asked for last
  Pose pose;                          ///< of the tool after that step
  std::vector<Pose> way;              ///< from there
  Approach approach;                  ///< to its end
  bool stale = false;
};

/// The receipt is forgotten.
template <class Archive>
void serialize(Archive& archive, ReceivedPose& waiting) {
  archive(waiting.pose, waiting.active, waiting.time);
}

template <class Archive>
void serialize(Archive& archive, ToolTrackerMemory& memory) {
  auto& [waiting, last, active, age, pose, way, approach, stale] = memory;
  archive(waiting, last, active, age, pose, way, approach, stale);
}

void check(const ToolTrackerMemory& memory, const MemoryLimits& limits);

/// Turns the tool's poses into its path in each step. When several came since the last step, all of them are the path;
/// one that comes more seldom than steps is approached evenly in the time since the one before it. The tool is put at
/// the first pose, and at one beyond `tool.max_step` from the one before it: a jump. A jump, or a switch of the blade,
/// among the poses of one step waits for the step after it, so that what comes before it is done first. Used by the
/// stepping thread.
class ToolTracker {
 public:
  /// `time_step` [s].
  ToolTracker(const ToolSettings& tool, const Edge& edge, double time_step);

  /// What the tool does in the next step. `now` is a time like those of the poses; times before the last call count as
  /// then, and 0 as now. In a `single` step, of a paused body, all poses are gone through and no time passes.
  ToolMove follow(const ToolInput& input, Nanoseconds now, bool single);

  /// There is no pose yet, or only a stale one at which the tool stands.
  void restart(const std::optional<Pose>& at = std::nullopt) noexcept;

  /// Goes on as if no time had passed since the step before keep(): its poses are as old as then.
  ToolTrackerMemory keep() const;
  void recall(ToolTrackerMemory memory) noexcept;

  /// The newest pose is older than `tool.timeout`: the tool stays where it is, the rest of its way is dropped. It
  /// goes on with the next pose, in the same stroke unless that is a jump.
  bool stale() const { return stale_; }

  /// Jumps so far.
  std::uint64_t jumps() const { return jumps_; }

 private:
  void resume(Nanoseconds now, bool single);
  void admit(const std::vector<ReceivedPose>& poses, Nanoseconds now, ToolMove* move);
  void dropOldest();
  bool jumps(const std::optional<Pose>& from, const Pose& to) const;
  bool beginsStroke(const ReceivedPose& pose) const;
  void take(const ReceivedPose& pose, ToolMove* move);
  void checkAge(Nanoseconds now, ToolMove* move);

  const double max_step_, timeout_;
  const Edge edge_;
  const double time_step_;

  std::vector<ReceivedPose> waiting_;
  std::optional<Pose> last_;  ///< newest pose that is on the way
  bool active_ = true;        ///< the blade is on on the way to it
  Nanoseconds last_time_ = 0;
  Pose pose_;              ///< of the tool after the step asked for last
  std::vector<Pose> way_;  ///< from there
  Approach approach_;      ///< to its end
  Nanoseconds last_call_ = 0;
  bool resumed_ = false;  ///< times are less the last call's, which is still to be known
  bool stale_ = false;
  std::uint64_t jumps_ = 0;
};

}  // namespace incision
