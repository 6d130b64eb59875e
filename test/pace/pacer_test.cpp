#include "incision/pace/pacer.h"

#include <gtest/gtest.h>

#include "pace/things_in_tests.h"

namespace incision {
namespace {

using std::chrono::milliseconds;

/// Feeds one clock message and takes all steps it allows; how many these were.
int stepsAfter(ClockPacer& pacer, SteadyTime received, Nanoseconds clock) {
  pacer.tick(received, clock);
  pacer.update(received + CLOCK_DELAY);
  int steps = 0;
  for (; pacer.due(); ++steps) pacer.stepTaken();
  return steps;
}

TEST(WallPacer, ALateStepIsNotMadeUpFor) {
  WallPacer pacer(TIME_STEP);
  pacer.update(START);
  EXPECT_TRUE(pacer.due());
  pacer.stepTaken();  // reads the wall clock, which is far past START: the next step is due at that time, and once
  const SteadyTime next = pacer.nextUpdate();
  pacer.update(next - milliseconds(1));
  EXPECT_FALSE(pacer.due());
  pacer.update(next);
  EXPECT_TRUE(pacer.due());
}

TEST(WallPacer, SkipsTheTimeByWhichAStepIsLate) {
  WallPacer pacer(TIME_STEP);
  const SteadyTime due = std::chrono::steady_clock::now() - milliseconds(25);
  pacer.update(due);
  EXPECT_EQ(0, pacer.skipped());
  pacer.stepTaken();  // planned for 15 ms ago, and not before now
  EXPECT_GE(pacer.skipped(), 0.015);
  EXPECT_NEAR(pacer.skipped(), std::chrono::duration<double>(pacer.nextUpdate() - due).count() - TIME_STEP, 1e-9);
  const double skipped = pacer.skipped();
  pacer.update(pacer.nextUpdate());
  pacer.stepTaken();  // in time
  EXPECT_EQ(skipped, pacer.skipped());
}

TEST(WallPacer, APauseSkipsNoTime) {
  WallPacer pacer(TIME_STEP);
  pacer.update(std::chrono::steady_clock::now() - std::chrono::hours(1));
  pacer.restart();
  pacer.update(std::chrono::steady_clock::now());
  pacer.stepTaken();
  EXPECT_LT(pacer.skipped(), 1);
}

TEST(ClockPacer, StepsStartOnMultiplesOfTheTimeStep) {
  ClockPacer pacer(TIME_STEP, 5);
  EXPECT_EQ(1, stepsAfter(pacer, START, 1003 * MILLISECOND));
  EXPECT_EQ(1010 * MILLISECOND, pacer.nextStart());
  EXPECT_EQ(0, stepsAfter(pacer, START + milliseconds(5), 1009 * MILLISECOND));
  EXPECT_EQ(1, stepsAfter(pacer, START + milliseconds(6), 1010 * MILLISECOND));
}

TEST(ClockPacer, AClockThatStartsALittleLaterGivesTheSameSteps) {
  ClockPacer early(TIME_STEP, 5), late(TIME_STEP, 5);
  stepsAfter(early, START, 1000 * MILLISECOND);
  stepsAfter(late, START, 1000 * MILLISECOND + 700'000);
  EXPECT_EQ(early.nextStart(), late.nextStart());
}

TEST(ClockPacer, AClockMessageWaitsForTheCommandsSentBeforeIt) {
  ClockPacer pacer(TIME_STEP, 5);
  pacer.tick(START, 1000 * MILLISECOND);
  pacer.update(START + CLOCK_DELAY - milliseconds(1));
  EXPECT_FALSE(pacer.due());
  EXPECT_EQ(START + CLOCK_DELAY, pacer.nextUpdate());
  pacer.update(START + CLOCK_DELAY);
  EXPECT_TRUE(pacer.due());
}

/// Three seconds of clock, in messages of 0.9 s, while no step is taken.
void fallBehind(ClockPacer& pacer) {
  stepsAfter(pacer, START, 1000 * MILLISECOND);
  for (int i = 1; i <= 3; ++i) {
    pacer.tick(START + milliseconds(i), (1000 + 900 * i) * MILLISECOND);
    pacer.update(START + milliseconds(i) + CLOCK_DELAY);
  }
}

TEST(ClockPacer, LagUpToItsLimitIsMadeUpFor) {
  ClockPacer pacer(TIME_STEP, 5);
  fallBehind(pacer);
  EXPECT_NEAR(2.69, pacer.lag(), 1e-9);  // 2.7 s less the step taken at the first message
  EXPECT_EQ(1010 * MILLISECOND, pacer.nextStart());
  EXPECT_EQ(0, pacer.skipped());
}

TEST(ClockPacer, LagBeyondItsLimitIsGivenUpAndCounted) {
  ClockPacer pacer(TIME_STEP, 2);
  fallBehind(pacer);
  EXPECT_EQ(0, pacer.lag());
  EXPECT_EQ(3700 * MILLISECOND, pacer.nextStart());
  EXPECT_NEAR(2.69, pacer.skipped(), 1e-9);
}

TEST(ClockPacer, AJumpOfTheClockTakesNoSteps) {
  ClockPacer pacer(TIME_STEP, 5);
  stepsAfter(pacer, START, 1000 * MILLISECOND);
  EXPECT_EQ(1, stepsAfter(pacer, START + milliseconds(1), 9000 * MILLISECOND));
  EXPECT_NEAR(7.99, pacer.skipped(), 1e-9);
  EXPECT_EQ(1, stepsAfter(pacer, START + milliseconds(2), 500 * MILLISECOND));
  EXPECT_NEAR(7.99, pacer.skipped(), 1e-9);  // it went back, and there was no lag
}

TEST(ClockPacer, LagBeforeTheClockGoesBackIsCounted) {
  ClockPacer pacer(TIME_STEP, 5);
  fallBehind(pacer);
  stepsAfter(pacer, START + milliseconds(4), 500 * MILLISECOND);
  EXPECT_NEAR(2.69, pacer.skipped(), 1e-9);
}

TEST(ClockPacer, WhatTheClockDoesBeforeTheFirstStepAndInAPauseIsNoSkippedTime) {
  ClockPacer pacer(TIME_STEP, 5);
  stepsAfter(pacer, START, 1'000'000'000'000'000);
  pacer.restart();
  stepsAfter(pacer, START + milliseconds(1), 1'000'009'000'000'000);
  EXPECT_EQ(0, pacer.skipped());
}

TEST(ClockPacer, ARestartWaitsForTheNextClockMessage) {
  ClockPacer pacer(TIME_STEP, 5);
  stepsAfter(pacer, START, 1000 * MILLISECOND);
  pacer.restart();
  pacer.update(START + milliseconds(100));
  EXPECT_FALSE(pacer.due());
  EXPECT_EQ(1, stepsAfter(pacer, START + milliseconds(200), 500 * MILLISECOND));
}

}  // namespace
}  // namespace incision
