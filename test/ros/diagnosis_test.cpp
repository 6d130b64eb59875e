#include "incision/ros/diagnosis.h"

#include <gtest/gtest.h>

namespace incision {
namespace {

using Level = diagnostic_msgs::DiagnosticStatus;

Condition running() {
  Condition condition;
  condition.steps = 100;
  condition.real_time_factor = 1;
  condition.tolerance = 1e-6;
  return condition;
}

StepTally hundredSteps(const StepResult& step = {}) {
  StepTally tally;
  for (int k = 0; k < 100; ++k) tally.add(step);
  return tally;
}

Status pace(const Condition& condition, const StepTally& tally) {
  Status status;
  tellPace(condition, tally, 1, &status);
  return status;
}

Status numerics(const Condition& condition, const StepTally& tally) {
  Status status;
  tellNumerics(condition, tally, &status);
  return status;
}

std::string valueOf(const Status& status, const std::string& key) {
  for (const auto& value : status.values)
    if (value.key == key) return value.value;
  return "none";
}

TEST(Pace, OfABodyInRealTimeIsWell) { EXPECT_EQ(pace(running(), hundredSteps()).level, Level::OK); }

TEST(Pace, OfAPausedBodyIsWellAndSaysSo) {
  Condition condition = running();
  condition.paused = true;
  condition.real_time_factor = 0;
  const Status status = pace(condition, {});
  EXPECT_EQ(status.level, Level::OK);
  EXPECT_EQ(status.message, "paused at step 100");
}

TEST(Pace, BelowRealTimeIsWarnedOf) {
  Condition condition = running();
  condition.real_time_factor = 0.5;
  const Status status = pace(condition, hundredSteps());
  EXPECT_EQ(status.level, Level::WARN);
  EXPECT_EQ(status.message, "slower than real time, at 0.5 of it");
  condition.by_clock = true;  // which may be as slow as it likes
  EXPECT_EQ(pace(condition, hundredSteps()).level, Level::OK);
  condition.clock_lag = 3;
  EXPECT_EQ(pace(condition, hundredSteps()).message, "3 s behind /clock");
}

TEST(Pace, WithoutAStepIsWarnedOf) {
  Condition condition = running();
  EXPECT_EQ(pace(condition, {}).message, "no step for 1 s: one takes longer than that");
  condition.by_clock = true;
  EXPECT_EQ(pace(condition, {}).message, "no step for 1 s: /clock stands still, or does not come");
}

TEST(Pace, SaysWhatTakesTheTime) {
  StepResult step;
  step.step_ms = 10;
  step.phase_ms.solve = 7;
  step.phase_ms.contact = 2;
  step.phase_ms.update = 0.01;
  const Status status = pace(running(), hundredSteps(step));
  EXPECT_EQ(valueOf(status, "what takes the time"), "solve 70 %, contact 20 %");
  EXPECT_EQ(valueOf(status, "step [ms], mean"), "10");
}

TEST(Numerics, OfStepsThatSettleAreSound) { EXPECT_EQ(numerics(running(), hundredSteps()).level, Level::OK); }

TEST(Numerics, OfAFailedStepAreAnError) {
  Condition condition = running();
  condition.paused = true;
  condition.error = "step 7 failed";
  const Status status = numerics(condition, {});
  EXPECT_EQ(status.level, Level::ERROR);
  EXPECT_EQ(status.message, "paused, because a step failed: step 7 failed");
}

TEST(Numerics, AreWarnedOf) {
  StepResult step;
  step.settled = false;
  EXPECT_EQ(numerics(running(), hundredSteps(step)).message, "100 steps did not settle");
  step = StepResult();
  step.divided = true;
  EXPECT_EQ(numerics(running(), hundredSteps(step)).message, "100 of 100 steps were taken in halves");
  step = StepResult();
  step.iterations = 50;
  step.residual = 1e-3;
  EXPECT_EQ(numerics(running(), hundredSteps(step)).message, "a residual of 0.001 misses the tolerance");
  step.residual = 2e-6;
  EXPECT_EQ(numerics(running(), hundredSteps(step)).level, Level::OK);
}

TEST(Input, IsWarnedOfWhileItIsNotFollowed) {
  const auto told = [](const InputCounts& counts, const InputCounts& before, const Waiting& waiting,
                       const std::vector<char>& stale) {
    Condition condition;
    condition.stale = stale;
    Status status;
    tellInput(counts, before, waiting, condition, {"scalpel", "hook"}, &status);
    return status;
  };
  InputCounts counts;
  EXPECT_EQ(told(counts, {}, {}, {0, 0}).level, Level::OK);
  counts.refused[1] = 3;
  EXPECT_EQ(told(counts, {}, {}, {0, 0}).message, "3 messages refused");
  EXPECT_EQ(told(counts, counts, {}, {0, 0}).level, Level::OK);
  EXPECT_EQ(valueOf(told(counts, counts, {}, {0, 0}), "refused, out of range"), "3");
  EXPECT_EQ(told(counts, counts, {}, {0, 1}).message, "no poses come for hook");
  EXPECT_EQ(told(counts, counts, {200, 0}, {0, 0}).level, Level::WARN);
  EXPECT_EQ(told(counts, counts, {0, 900}, {0, 0}).level, Level::WARN);
  counts.late = 1;
  EXPECT_EQ(told(counts, {}, {}, {1, 0}).message,
            "3 messages refused; 1 cuts and messages to tools came late; no poses come for scalpel");
}

TEST(Memory, ThatIsNearlyUsedUpIsWarnedOf) {
  const auto level = [](const MemoryUse& use) {
    Status status;
    tellMemory(use, &status);
    return status.level;
  };
  EXPECT_EQ(level({1e8, 1e8, 5e9, 8e9}), Level::OK);
  EXPECT_EQ(level({7e9, 7e9, 5e8, 8e9}), Level::WARN);
  EXPECT_EQ(level({1e8, 1e8, 0, 0}), Level::OK);  // not known
  const MemoryUse own = memoryUse();
  EXPECT_GT(own.resident, 1e6);
  EXPECT_GE(own.peak, own.resident);
  EXPECT_GT(own.total, own.available);
}

}  // namespace
}  // namespace incision
