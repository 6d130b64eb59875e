#pragma once

#include <diagnostic_updater/DiagnosticStatusWrapper.h>

#include <array>
#include <cstdint>
#include <string>
#include <vector>

#include "incision/pace/command.h"
#include "incision/run/step_tally.h"

namespace incision {

/// How a node is at a moment, as far as its stepping thread alone knows.
struct Condition {
  bool paused = false, by_clock = false;  ///< the latter: steps go by /clock
  std::string error;                      ///< why the last step failed; empty when it did not
  std::int64_t steps = 0;                 ///< of the body
  double real_time_factor = 0;            ///< 0: not known yet
  double clock_lag = 0;                   ///< [s]
  double tolerance = 0;                   ///< of iterative solves
  std::uint64_t ignored_transforms = 0;
  std::vector<char> stale;  ///< of each tool, whether it holds still because no pose comes
};

/// Messages since the start.
struct InputCounts {
  std::array<std::uint64_t, NUM_REFUSALS> refused = {};
  std::uint64_t late = 0, thinned = 0, ignored_transforms = 0;

  bool operator==(const InputCounts& other) const {
    return refused == other.refused && late == other.late && thinned == other.thinned &&
           ignored_transforms == other.ignored_transforms;
  }
};

/// Commands that wait now.
struct Waiting {
  std::size_t for_transform = 0, for_step = 0;
};

/// [bytes]
struct MemoryUse {
  double resident = 0, peak = 0;    ///< of this process
  double available = 0, total = 0;  ///< of the machine; 0: not known
};
MemoryUse memoryUse();

using Status = diagnostic_updater::DiagnosticStatusWrapper;

/// Each tells its part of the diagnosis: a level with its reason, and the numbers. The tally is of the steps since the
/// last one. A body that is paused is well, unless a step has failed.
void tellPace(const Condition& condition, const StepTally& tally, double period, Status* status);
void tellNumerics(const Condition& condition, const StepTally& tally, Status* status);
/// `before`: at the last diagnosis. `tools`: their names.
void tellInput(const InputCounts& counts, const InputCounts& before, const Waiting& waiting, const Condition& condition,
               const std::vector<std::string>& tools, Status* status);
void tellMemory(const MemoryUse& use, Status* status);

}  // namespace incision
