#include "incision/solver/backward_difference.h"

#include <gtest/gtest.h>

#include <Eigen/Eigenvalues>
#include <cmath>
#include <complex>

#include "support/rig.h"

namespace incision {
namespace {

const Vec3 SIZE(0.6, 0.4, 0.4);

// A rig that takes steps of second order.
struct SecondOrderRig : Rig {
  explicit SecondOrderRig(const RigSettings& settings) : Rig(block({3, 2, 2}, SIZE), settings) {}

  bool advance() {
    const bool done = past.advance(time, time_step, &step, &motion);
    time += time_step;
    return done;
  }

  BackwardDifference past;
};

// y' = λ y by the formula, after a step of implicit Euler.
std::vector<std::complex<double>> formula(std::complex<double> y, std::complex<double> lambda_step, int steps) {
  std::vector<std::complex<double>> values = {y, y / (1.0 - lambda_step)};
  for (int n = 2; n <= steps; ++n) values.push_back((2.0 * values[n - 1] - 0.5 * values[n - 2]) / (1.5 - lambda_step));
  return values;
}

TEST(BackwardDifference, AModeFollowsTheFormula) {
  for (const double phase_step : {0.1, 1.0, 5.0}) {
    RigSettings settings;
    settings.warping = false;
    settings.conditions.clamps = {{slab(0, 0), Vec3::Zero()}};
    const SecondOrderRig probe(settings);
    const std::vector<int> copies = probe.freeCopies();
    const Eigen::MatrixXd K = systemMatrix(probe.step.assembly(), {0, 1}, copies);
    const Eigen::MatrixXd M = systemMatrix(probe.step.assembly(), {1, 0}, copies);
    const Eigen::GeneralizedSelfAdjointEigenSolver<Eigen::MatrixXd> modes(K, M);
    const double omega = std::sqrt(modes.eigenvalues()[2]);
    const Eigen::VectorXd mode = modes.eigenvectors().col(2);

    settings.solver.time_step = phase_step / omega;
    SecondOrderRig rig(settings);
    for (std::size_t i = 0; i < copies.size(); ++i) rig.motion.x[copies[i]] += mode.segment<3>(3 * i);
    // With q the mode's amplitude, y = q − i q'/ω turns as exp(i ω t).
    const auto expected = formula(1, {0, phase_step}, 20);
    for (int n = 1; n <= 20; ++n) {
      ASSERT_TRUE(rig.advance());
      const std::vector<Vec3> u = rig.displacements();
      Eigen::VectorXd x(3 * copies.size()), v(3 * copies.size());
      for (std::size_t i = 0; i < copies.size(); ++i) {
        x.segment<3>(3 * i) = u[copies[i]];
        v.segment<3>(3 * i) = rig.motion.v[copies[i]];
      }
      const std::complex<double> y(mode.dot(M * x), -mode.dot(M * v) / omega);
      // Modes are known to about 1e-12 of the largest.
      EXPECT_LT(std::abs(y - expected[n]), 1e-9) << "step " << n << " of " << phase_step;
    }
  }
}

// Where a free, warped block that spins and swings is after 0.2 s.
std::vector<Vec3> whereItIs(double time_step) {
  RigSettings settings;
  settings.material.young_modulus = 1e5;
  settings.solver.time_step = time_step;
  SecondOrderRig rig(settings);
  for (std::size_t c = 0; c < rig.motion.x.size(); ++c) {
    const Vec3 X = rig.motion.x[c];
    rig.motion.v[c] = Vec3(3, 4, 5).cross(X - SIZE / 2) + Vec3(0, 0, X.x() * X.x());
  }
  while (rig.time < 0.2 - time_step / 2) EXPECT_TRUE(rig.advance());
  return rig.motion.x;
}

TEST(BackwardDifference, LargeTurnsConvergeAtSecondOrder) {
  const std::vector<Vec3> coarse = whereItIs(2.5e-4), middle = whereItIs(1.25e-4), fine = whereItIs(6.25e-5);
  const double order = std::log2(largestDifference(coarse, middle) / largestDifference(middle, fine));
  EXPECT_NEAR(order, 2, 0.2);
}

// Turns of up to half a radian a step.
TEST(BackwardDifference, WhatSpinsGainsNoEnergy) {
  for (const double young_modulus : {1e6, 1e8})
    for (const double time_step : {0.005, 0.02, 0.05}) {
      RigSettings settings;
      settings.material.young_modulus = young_modulus;
      settings.solver.time_step = time_step;
      SecondOrderRig rig(settings);
      for (std::size_t c = 0; c < rig.motion.x.size(); ++c)
        rig.motion.v[c] = Vec3(10, 0, 5).cross(rig.motion.x[c] - SIZE / 2);
      const double first = rig.energy();
      while (rig.time < 1) {
        ASSERT_TRUE(rig.advance());
        ASSERT_LT(rig.energy() / first - 1, 2e-3) << young_modulus << " Pa, " << time_step << " s";
      }
    }
}

TEST(BackwardDifference, PiecesFallAsTheFormulaSays) {
  RigSettings settings;
  settings.conditions.gravity = Vec3(1, -2, -9);
  SecondOrderRig rig(settings);
  double v = 0, x = 0, v_before = 0, x_before = 0;  // along gravity, of unit size
  bool known = false;
  for (int n = 0; n < 20; ++n) {
    if (n == 10) {
      EXPECT_TRUE(rig.cut(plane(rig.motion.x[0] + Vec3(0.31, 0.2, 0.2), Vec3(1, 0.3, -0.1))).changed());
      rig.past.forget();
      known = false;
    }
    const double h = known ? 2 * rig.time_step / 3 : rig.time_step, share = known ? 1.0 / 3 : 0;
    const double v_next = v + share * (v - v_before) + h, x_next = x + share * (x - x_before) + h * v_next;
    v_before = std::exchange(v, v_next);
    x_before = std::exchange(x, x_next);
    known = true;
    ASSERT_TRUE(rig.advance());
    // Rounding of positions of 0.6 m drives the lightest copies: some 1e-13 of the fall.
    for (const Vec3& velocity : rig.motion.v)
      ASSERT_LT((velocity - v * settings.conditions.gravity).norm(), 1e-11 * velocity.norm());
    for (const Vec3& u : rig.displacements()) ASSERT_LT((u - x * settings.conditions.gravity).norm(), 1e-11 * u.norm());
  }
  EXPECT_EQ(rig.pieces(), 2);
}

TEST(BackwardDifference, WhatIsHeldMovesWithItsHold) {
  RigSettings settings;
  settings.conditions.clamps = {{slab(0, 0), Vec3(0.3, 0, 0)}};
  SecondOrderRig rig(settings);
  const std::vector<Vec3> X = rig.motion.x;
  for (int n = 0; n < 10; ++n) ASSERT_TRUE(rig.advance());
  for (std::size_t c = 0; c < X.size(); ++c) {
    if (rig.step.held()[c] >= 0) {
      EXPECT_LT((rig.motion.x[c] - X[c] - Vec3(0.03, 0, 0)).norm(), 1e-15);
    }
  }
}

}  // namespace
}  // namespace incision
