#pragma once

#include <string>

#include "incision/body/deformable_body.h"

namespace incision {

/// What some steps had in all.
struct StepTally {
  int steps = 0, unsettled = 0, divided = 0;
  double step_ms = 0, longest_ms = 0;  ///< in all, and the longest
  PhaseTimes phase_ms;                 ///< in all
  double residual = 0;                 ///< the largest, of iterative solves
  int iterations = 0;                  ///< the most

  void add(const StepResult& step);
};

/// A part of the step, and its share of the steps' time, from 0 to 1.
struct PhaseShare {
  std::string phase;
  double share;
};

/// What takes the time: of what is a hundredth of it or more, the longest first. Nothing without steps.
std::vector<PhaseShare> sharesOf(const StepTally& tally);

/// "solve 61 %, contact 20 %".
std::string describe(const std::vector<PhaseShare>& shares);

}  // namespace incision
