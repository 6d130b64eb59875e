#include "incision/fracture/rankine.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "support/random.h"

namespace incision::test {
namespace {

constexpr double INF = std::numeric_limits<double>::infinity();

Strength strengths(double tensile, double compressive) { return {tensile, compressive}; }

Mat3 principal(const Mat3& R, double smallest, double middle, double largest) {
  return R * Vec3(smallest, middle, largest).asDiagonal() * R.transpose();
}

TEST(Rankine, TheStressThatComesCloserToItsStrengthDecides) {
  Random random(1);
  for (int k = 0; k < 100; ++k) {
    const Mat3 stress = principal(random.rotation(), -6e4, 1e3, 2e4);
    const Loading tension = rankine(stress, strengths(1e4, 4e4)), compression = rankine(stress, strengths(2e4, 4e4));
    EXPECT_EQ(tension.kind, FailureKind::TENSION);
    EXPECT_NEAR(tension.share, 2, 1e-7);  // the closed form's digits
    EXPECT_NEAR(tension.stress, 2e4, 1e-3);
    EXPECT_EQ(compression.kind, FailureKind::COMPRESSION);
    EXPECT_NEAR(compression.share, 1.5, 1e-7);
    EXPECT_NEAR(compression.stress, -6e4, 1e-3);
  }
}

TEST(Rankine, AnInfiniteStrengthIsNeverReached) {
  const Mat3 push = principal(Mat3::Identity(), -1e12, -1e9, -1e9), pull = -push;
  EXPECT_EQ(rankine(push, strengths(1, INF)).share, 0);
  EXPECT_EQ(rankine(pull, strengths(INF, 1)).share, 0);
}

TEST(Rankine, WhatIsNotFiniteLoadsNothing) {
  Mat3 stress = Mat3::Identity();
  stress(0, 1) = stress(1, 0) = std::numeric_limits<double>::quiet_NaN();
  EXPECT_FALSE(rankine(stress, strengths(1e-9, 1e-9)).share > 0);
  EXPECT_FALSE(rankine(Mat3::Constant(INF), strengths(1e-9, 1e-9)).share > 0);
}

TEST(Rankine, TheCrackLiesAcrossTheLargestPrincipalStress) {
  Random random(2);
  for (int k = 0; k < 100; ++k) {
    const Mat3 R = random.rotation();
    EXPECT_NEAR(std::abs(crackNormal(principal(R, -1e4, 1e3, 3e3)).dot(R.col(2))), 1, 1e-12);
    // Close principal stresses: their directions are still good to the rounding over their distance.
    EXPECT_NEAR(std::abs(crackNormal(principal(R, 0, 1, 1 + 1e-6)).dot(R.col(2))), 1, 1e-9);
  }
}

TEST(Rankine, SimpleShearCracksAtHalfARightAngle) {
  Mat3 shear = Mat3::Zero();
  shear(0, 1) = shear(1, 0) = 5e3;
  const Vec3 n = crackNormal(shear);
  EXPECT_NEAR(std::abs(n.dot(Vec3(1, 1, 0).normalized())), 1, 1e-12);
  EXPECT_NEAR(rankine(shear, strengths(1e4, INF)).share, 0.5, 1e-12);
}

TEST(Rankine, AColumnSplitsAlongThePush) {
  const Vec3 push = Vec3(1, 2, 3).normalized();
  EXPECT_NEAR(crackNormal(-1e4 * push * push.transpose()).dot(push), 0, 1e-7);
}

}  // namespace
}  // namespace incision::test
