#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "incision/pace/clamp_tracker.h"
#include "incision/pace/commands.h"
#include "incision/pace/leads_memory.h"
#include "incision/pace/link_tracker.h"
#include "incision/pace/pacer.h"
#include "incision/pace/tool_guide.h"

namespace incision {

/// A step waits for commands that wait for their transform as long as it is less than this [s] behind the clock:
/// messages with unknown frames can delay the body by no more.
inline constexpr double MAX_DELAY = 0.5;

/// What the body is told before its steps, and when they start: all between messages and the body. The node and what
/// runs a bag share it, so that they take the same steps. Used by the stepping thread.
class StepInput {
 public:
  /// All must outlive this.
  StepInput(DeformableBody& body, Pacer& pacer, Commands& commands, const Frames& frames, Answers& answers);

  /// What is to be done now.
  struct Due {
    bool step = false;  ///< the next step may start
    bool cut = false;   ///< the body was cut before it
  };
  /// Brings the clock up to now and makes the cuts that are due.
  Due update(SteadyTime now);

  /// Right before a step: tools, obstacles and clamps go where it shall take them.
  void lead(SteadyTime now);

  void stepTaken() { pacer_.stepTaken(); }

  /// While the body is paused no step is due, and cuts take effect at once.
  void setPaused(bool paused);
  bool paused() const { return paused_; }

  /// After a reset of the body: all that waits is refused, every cut among it with this reason; tools are led from
  /// their next poses on, obstacles and clamps from where they were at first.
  void restart(const Refused& refused) noexcept;

  /// How it leads what moves, as far as that outlasts a step.
  LeadsMemory keep() const;
  /// After the body has been restored: all that waits is refused, every cut among it with this reason, and what moves
  /// is led on; without a memory tools are taken over where they stand. Takes no memory from the heap, since the body
  /// could not be had back. `memory` is of as many tools, links and clamps.
  void recall(std::optional<LeadsMemory> memory, const Refused& refused) noexcept;

  const std::vector<ToolGuide>& tools() const { return tools_; }
  /// Where the obstacles' links are, or are going in the step asked for last.
  const std::vector<Pose>& obstaclePoses() const { return obstacles_.poses(); }
  /// Transforms that were of no use, so far.
  std::uint64_t ignored() const;

 private:
  void takeOver() noexcept;
  bool stepDue() const;
  bool applyCuts(bool step_due);
  StepTime stepTime(SteadyTime now) const;
  void moveObstacles(const StepTime& time);
  void moveClamps(const StepTime& time);
  void warnOfJump(const std::string& what, double speed, const std::string& then);

  DeformableBody& body_;
  Pacer& pacer_;
  Commands& commands_;
  Answers& answers_;
  std::vector<ToolGuide> tools_;
  LinkTracker obstacles_;
  ClampTracker clamps_;
  bool paused_ = false;
};

}  // namespace incision
