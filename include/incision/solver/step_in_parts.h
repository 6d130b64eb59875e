#pragma once

#include "incision/solver/coupler.h"
#include "incision/solver/implicit_step.h"

namespace incision {

/// How often a step is halved that does not settle.
inline constexpr int MAX_HALVINGS_TO_SETTLE = 3;

/// How often one is halved that fails, or turns what couplers act on too far: a small fragment that is pinched may spin
/// at hundreds of radians a second, and would be driven faster without bounds in steps in which it turns on and on.
inline constexpr int MAX_HALVINGS = 6;

/// Takes a step from `time` [s], in halves where it must be, and these likewise. `attempt(span, time, demand)` takes a
/// part of it, or returns false with nothing changed; `recall(keep())` undoes all since. Returns false, with nothing
/// changed, where a part fails however short it is.
template <class Attempt, class Keep, class Recall>
bool advanceInParts(const StepSpan& span, double time, const Attempt& attempt, const Keep& keep, const Recall& recall,
                    int halvings = 0) {
  if (halvings == MAX_HALVINGS) return attempt(span, time, StepDemand::ANY);
  if (attempt(span, time, halvings < MAX_HALVINGS_TO_SETTLE ? StepDemand::SOUND : StepDemand::SHORT_TURNS)) return true;
  const auto before = keep();
  const double half = span.time_step / 2, middle = (span.from + span.to) / 2;
  const auto advanceHalf = [&](double from, double to, double start) {
    return advanceInParts({half, from, to}, start, attempt, keep, recall, halvings + 1);
  };
  if (advanceHalf(span.from, middle, time) && advanceHalf(middle, span.to, time + half)) return true;
  recall(before);
  return false;
}

}  // namespace incision
