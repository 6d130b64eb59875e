#include "incision/run/step_tally.h"

#include <gtest/gtest.h>

namespace incision {
namespace {

StepResult step(double step_ms, const PhaseTimes& phases) {
  StepResult result;
  result.step_ms = step_ms;
  result.phase_ms = phases;
  return result;
}

TEST(StepTally, AddsUpWhatStepsHave) {
  StepTally tally;
  StepResult result = step(4, {});
  result.settled = false;
  result.divided = true;
  result.iterations = 3;
  result.residual = 1e-7;
  tally.add(result);
  tally.add(step(2, {}));
  EXPECT_EQ(tally.steps, 2);
  EXPECT_EQ(tally.unsettled, 1);
  EXPECT_EQ(tally.divided, 1);
  EXPECT_EQ(tally.step_ms, 6);
  EXPECT_EQ(tally.longest_ms, 4);
  EXPECT_EQ(tally.iterations, 3);
  EXPECT_EQ(tally.residual, 1e-7);
}

TEST(SharesOf, TheLongestPhaseComesFirstAndLessThanAHundredthIsLeftOut) {
  StepTally tally;
  EXPECT_EQ(describe(sharesOf(tally)), "");
  PhaseTimes phases;
  phases.contact = 2;
  phases.solve = 6;
  phases.update = 0.05;
  tally.add(step(10, phases));
  phases.contact = 4;
  tally.add(step(10, phases));
  EXPECT_EQ(describe(sharesOf(tally)), "solve 60 %, contact 30 %");
  EXPECT_EQ(sharesOf(tally)[1].phase, "contact");
  EXPECT_DOUBLE_EQ(sharesOf(tally)[1].share, 0.3);
}

}  // namespace
}  // namespace incision
