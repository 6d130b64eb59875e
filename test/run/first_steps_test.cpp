#include "incision/run/first_steps.h"

#include <gtest/gtest.h>

namespace incision {
namespace {

TEST(FirstSteps, TellTheirMedianOnceAfterTheTenth) {
  FirstSteps steps(0.01);
  for (const double ms : {90.0, 2.0, 2.0, 2.2, 2.2, 2.0, 2.0, 2.2, 2.2}) EXPECT_FALSE(steps.add(ms));
  EXPECT_EQ(steps.add(2.0).value_or(""),
            "a step of 10 ms takes 2.1 ms (median of the first ten): 4.8 times as fast as real time");
  for (int k = 0; k < 20; ++k) EXPECT_FALSE(steps.add(100));
}

TEST(FirstSteps, AreOfRealTimeWhereTheyTakeLonger) {
  FirstSteps steps(0.0025);
  for (int k = 0; k < 9; ++k) steps.add(10);
  EXPECT_EQ(steps.add(10).value_or(""), "a step of 2.5 ms takes 10 ms (median of the first ten): 0.25 of real time");
}

TEST(PaceInWords, IsThatOfRealTimeWhereBothAreAlike) {
  EXPECT_EQ(paceInWords(3, 3), "1 times as fast as real time");
  EXPECT_EQ(paceInWords(1, 1000), "0.001 of real time");
}

}  // namespace
}  // namespace incision
