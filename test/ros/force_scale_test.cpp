#include "incision/ros/force_scale.h"

#include <gtest/gtest.h>

#include <cmath>

namespace incision {
namespace {

constexpr double SIZE = 0.3, LEAST = 1e-3;

TEST(ForceScale, IsAOneATwoOrAFiveAndTheArrowFits) {
  for (double force = 0.01; force < 1e4; force *= 1.37) {
    const double scale = ForceScale(SIZE, LEAST).at(0, force);
    EXPECT_LE(scale * force, SIZE / 3 * (1 + 1e-9)) << force;
    EXPECT_GE(scale * force, SIZE / 7.6) << force;
    const double digit = scale / std::pow(10, std::floor(std::log10(scale * (1 + 1e-9))));
    EXPECT_TRUE(std::abs(digit - 1) < 1e-9 || std::abs(digit - 2) < 1e-9 || std::abs(digit - 5) < 1e-9) << scale;
  }
}

TEST(ForceScale, StaysWhileForcesVary) {
  ForceScale of(SIZE, LEAST);
  const double scale = of.at(0, 1);
  for (int k = 1; k < 1000; ++k) EXPECT_EQ(scale, of.at(0.01 * k, 0.5 + 0.5 * std::sin(k)));
}

TEST(ForceScale, ShrinksAtOnceForALargerForceAndGrowsAgainWhenABlowIsForgotten) {
  ForceScale of(SIZE, LEAST);
  const double before = of.at(0, 1);
  EXPECT_LT(of.at(0.01, 1000), before / 500);
  EXPECT_LT(of.at(5, 1), before / 400);
  EXPECT_EQ(of.at(60, 1), before);
}

TEST(ForceScale, DoesNotBlowUpWhatIsNothing) {
  ForceScale of(SIZE, LEAST);
  const double scale = of.at(0, 0);
  EXPECT_LE(scale * LEAST, SIZE / 3 * (1 + 1e-9));
  EXPECT_EQ(of.at(1000, 1e-12), scale);
}

TEST(ForceScale, BeginsAnewWhenTimeDoes) {
  ForceScale of(SIZE, LEAST), fresh(SIZE, LEAST);
  of.at(100, 1000);
  EXPECT_EQ(of.at(0, 1), fresh.at(0, 1));
}

}  // namespace
}  // namespace incision
