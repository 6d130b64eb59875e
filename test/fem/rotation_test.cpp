#include "incision/fem/rotation.h"

#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <Eigen/LU>
#include <Eigen/SVD>
#include <random>

namespace incision {
namespace {

constexpr double ROUNDING = 1e-13;

class Rotations : public ::testing::Test {
 protected:
  double uniform() { return std::uniform_real_distribution<double>(-1, 1)(generator_); }
  Mat3 randomRotation() {
    std::normal_distribution<double> normal;
    return Eigen::Quaterniond(normal(generator_), normal(generator_), normal(generator_), normal(generator_))
        .normalized()
        .toRotationMatrix();
  }
  // With the given singular values; a negative one inverts.
  Mat3 withStretches(const Vec3& stretches) {
    return randomRotation() * stretches.asDiagonal() * randomRotation().transpose();
  }
  std::mt19937 generator_{11};
};

// σ₁ + σ₂ ± σ₃, the largest trace a proper rotation can reach.
double bestTrace(const Mat3& F) {
  const Vec3 s = Eigen::JacobiSVD<Mat3>(F).singularValues();
  return s[0] + s[1] + (F.determinant() < 0 ? -s[2] : s[2]);
}

void expectBest(const Mat3& F, const Mat3& R) {
  const double scale = F.cwiseAbs().maxCoeff();
  EXPECT_LT((R.transpose() * R - Mat3::Identity()).norm(), ROUNDING);
  EXPECT_NEAR(R.determinant(), 1, ROUNDING);
  if (scale == 0) return;
  EXPECT_NEAR((R.transpose() * F).trace() / scale, bestTrace(F / scale), 10 * ROUNDING) << F;
}

const std::vector<Vec3> STRETCHES = {
    {1, 1, 1},     {2, 1, 0.5},     {3, 3, 3},     {1e3, 1, 1e-3},        // as they come
    {1, 0.8, 0},   {1, 1, 0},       {1, 0, 0},     {0, 0, 0},             // flat, a line, a point
    {1, 0.8, -.5}, {1, 0.8, -1e-9}, {1, 1, -1},    {2, 0.5, -0.5},        // inverted
    {1, 1e-9, 0},  {1, 0.5, 1e-12}, {1, 1e-8, -0}, {1, 1e-8, -0.999e-8},  // nearly so
};

TEST_F(Rotations, AreProperAndMaximiseTheTraceForAnyStretch) {
  for (const Vec3& stretches : STRETCHES)
    for (int i = 0; i < 50; ++i) {
      const Mat3 F = withStretches(stretches);
      expectBest(F, polarRotation(F, Mat3::Identity()));
      expectBest(F, polarRotation(F, randomRotation()));
    }
}

TEST_F(Rotations, NoSampledRotationDoesBetter) {
  for (const Vec3& stretches : STRETCHES)
    for (int i = 0; i < 5; ++i) {
      const Mat3 F = withStretches(stretches);
      const double trace = (polarRotation(F, randomRotation()).transpose() * F).trace();
      for (int k = 0; k < 200; ++k)
        EXPECT_LE((randomRotation().transpose() * F).trace(), trace + 10 * ROUNDING * stretches.cwiseAbs().maxCoeff());
    }
}

TEST_F(Rotations, EqualThoseOfTheSingularValues) {
  for (int i = 0; i < 2000; ++i) {
    Mat3 F;
    for (int k = 0; k < 9; ++k) F(k) = uniform();
    const Eigen::JacobiSVD<Mat3> svd(F, Eigen::ComputeFullU | Eigen::ComputeFullV);
    const Vec3 s = svd.singularValues();
    const double sign = F.determinant() < 0 ? -1 : 1;
    const double gap = s[1] + sign * s[2];  // where it is zero the rotation is not unique
    if (gap < 1e-6) continue;
    const Mat3 R = svd.matrixU() * Vec3(1, 1, sign).asDiagonal() * svd.matrixV().transpose();
    EXPECT_LT((polarRotation(F, randomRotation()) - R).norm(), ROUNDING / gap) << F;
    EXPECT_LT((polarRotation(F, R) - R).norm(), ROUNDING / gap) << F;
  }
}

TEST_F(Rotations, AreFoundFromANearbyGuess) {
  for (int i = 0; i < 500; ++i) {
    const Mat3 R = randomRotation();
    const Mat3 S = randomRotation();
    const Mat3 F = R * (S * Vec3(1.5, 1, 0.4).asDiagonal() * S.transpose());
    const Vec3 turn = 0.4 * Vec3(uniform(), uniform(), uniform());
    const Mat3 guess = R * Eigen::AngleAxisd(turn.norm(), turn.normalized()).toRotationMatrix();
    EXPECT_LT((polarRotation(F, guess) - R).norm(), ROUNDING);
  }
}

TEST_F(Rotations, DoNotDependOnTheScale) {
  for (const double scale : {1e-150, 1e-12, 1e12, 1e150}) {
    const Mat3 F = withStretches(Vec3(1, 0.7, 0.3));
    EXPECT_LT((polarRotation(scale * F, Mat3::Identity()) - polarRotation(F, Mat3::Identity())).norm(), ROUNDING);
  }
}

TEST_F(Rotations, StayProperOverManySteps) {
  Mat3 R = Mat3::Identity();
  const Mat3 turn = Eigen::AngleAxisd(0.01, Vec3(1, 2, 3).normalized()).toRotationMatrix();
  Mat3 F = withStretches(Vec3(1.2, 1, 0.9));
  for (int n = 0; n < 100'000; ++n) R = polarRotation(F = turn * F, R);
  expectBest(F, R);
}

// Side by side: small turns from the guess, a half turn, inverted and flat ones in one group.
TEST(PolarRotations, EqualThoseFoundOneByOne) {
  std::mt19937 generator(7);
  std::uniform_real_distribution<double> uniform(-1, 1);
  for (int round = 0; round < 2000; ++round) {
    std::array<Mat3, LANES> F, R;
    for (int l = 0; l < LANES; ++l) {
      const double turn = round % 4 == 0 && l == 1 ? 3 : 0.05, strain = round % 8 == 1 ? 0.9 : 0.2;
      R[l] = Eigen::Quaterniond(uniform(generator), uniform(generator), uniform(generator), uniform(generator))
                 .normalized()
                 .toRotationMatrix();
      F[l] = Mat3::NullaryExpr([&] { return strain * uniform(generator); });
      F[l] = R[l] * Eigen::AngleAxisd(turn, Vec3(uniform(generator), 1, uniform(generator)).normalized()) *
             (Mat3::Identity() + 0.5 * (F[l] + F[l].transpose()));
      if (round % 16 == 2 && l == 2) F[l].col(0) = F[l].col(1);
    }
    const std::array<Mat3, LANES> guess = R;
    polarRotations(F.data(), R.data());
    for (int l = 0; l < LANES; ++l) {
      EXPECT_LT((R[l].transpose() * R[l] - Mat3::Identity()).norm(), 1e-14);
      // What counts is the maximum: where it is flat the rotations may differ.
      EXPECT_NEAR((R[l].transpose() * F[l]).trace(), (polarRotation(F[l], guess[l]).transpose() * F[l]).trace(), 1e-13);
    }
  }
}

}  // namespace
}  // namespace incision
