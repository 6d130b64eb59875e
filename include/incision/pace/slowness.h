#pragma once

#include <optional>
#include <string>

#include "incision/pace/command.h"
#include "incision/run/step_tally.h"

namespace incision {

/// A body is slow below this real-time factor. A tenth is more than what the scheduling of a busy machine takes.
inline constexpr double SLOW = 0.9;

/// For so long [s] of wall time the factor is taken: a single cut into a large body, some tenths of a second, is none.
inline constexpr double SLOW_FOR = 5;

/// Says that steps do not keep up with wall time, what takes the time, and what would help: once, until they have kept
/// up again. Used by the stepping thread.
class Slowness {
 public:
  /// `time_step` [s]; whether the scene lets pieces touch each other.
  Slowness(double time_step, bool self_contact) : time_step_(time_step), self_contact_(self_contact) {}

  /// A new time to look at: at the start, and after a pause.
  void restart(SteadyTime now);
  void stepTaken(const StepResult& step) { tally_.add(step); }

  /// A line for people when SLOW_FOR has passed, if there is something new to say. `threads`: how many the solver has,
  /// and how many the machine.
  std::optional<std::string> look(SteadyTime now, int threads, int machine_threads);

 private:
  std::string inWords(double passed, int threads, int machine_threads) const;

  const double time_step_;
  const bool self_contact_;
  bool told_ = false;
  SteadyTime start_;
  StepTally tally_;  ///< since then
};

}  // namespace incision
