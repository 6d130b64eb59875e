#pragma once

#include <cstdint>
#include <vector>

#include "incision/pace/answers.h"
#include "incision/pace/commands.h"
#include "incision/pace/pacer.h"

namespace incision {

/// A command that waits longer than this [s] by time of receipt is warned of: a plan that is sent ahead of time rarely
/// is by more, and whoever waits for a report begins to wonder.
inline constexpr double LONG_WAIT = 3;

/// Skipped time is warned of where it is more than this share of the time that passes. Less is the unevenness of a busy
/// machine.
inline constexpr double SKIPPED_SHARE = 0.1;

/// A stamp further ahead of the clock than this [s] is no plan: it is of another clock.
inline constexpr double OTHER_CLOCK = 3600;

/// Looks now and then whether something is lost or waits for long, and warns of it. Used by the stepping thread.
class PaceWatch {
 public:
  PaceWatch(const Pacer& pacer, const Commands& commands, Answers& answers)
      : pacer_(pacer), commands_(commands), answers_(answers), thinned_(commands.tools().size()) {}

  /// Does something only when WARNING_PERIOD has passed.
  void look(SteadyTime now);

 private:
  void lookAtSkippedTime(double passed);
  void lookAtThinnedPoses();
  void lookAtWaitingCommands(SteadyTime now);

  const Pacer& pacer_;
  const Commands& commands_;
  Answers& answers_;
  SteadyTime last_look_;
  double skipped_ = 0;
  std::vector<std::uint64_t> thinned_;  ///< of each tool
};

}  // namespace incision
