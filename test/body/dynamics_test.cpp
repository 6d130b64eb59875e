#include <gtest/gtest.h>

#include <Eigen/Eigenvalues>
#include <Eigen/SparseCholesky>
#include <cmath>
#include <memory>

#include "support/rig.h"

namespace incision {
namespace {

const Vec3 GRAVITY(1, -2, -9);

// Lets a block fall for 30 steps while it is cut into pieces, and compares every copy with backward Euler's
// v_n = −g n Δt, x_n = −g Δt² n (n + 1)/2. Returns the largest error relative to the fall.
double errorOfFall(const RigSettings& given, const std::vector<PlaneCut>& cuts) {
  RigSettings settings = given;
  settings.conditions.gravity = GRAVITY;
  Rig rig(block({3, 2, 2}, Vec3(0.6, 0.4, 0.4)), settings);
  const double dt = rig.time_step;
  std::size_t next = 0;
  double worst = 0;
  for (int n = 1; n <= 30; ++n) {
    if (n % 5 == 0 && next < cuts.size()) {
      PlaneCut cut = cuts[next++];
      cut.point += GRAVITY * dt * dt * (n - 1) * n / 2;  // given where the body was at rest
      EXPECT_TRUE(rig.cut(cut).changed());
    }
    EXPECT_TRUE(rig.advance());
    const Vec3 v = GRAVITY * n * dt, u = GRAVITY * dt * dt * n * (n + 1) / 2;
    for (const Vec3& velocity : rig.motion.v) worst = std::max(worst, (velocity - v).norm() / v.norm());
    for (const Vec3& displacement : rig.displacements()) worst = std::max(worst, (displacement - u).norm() / u.norm());
  }
  EXPECT_EQ(next, cuts.size());
  return worst;
}

// Rounding of positions of 0.6 m, as strain, drives the lightest copies with E ε / (ρ h): some 1e-13 of the fall.
constexpr double FALL_TOLERANCE = 1e-11;

// A piece, then quarters, then a corner of share 1e-6 of its element, which holds one node, and at last one with none.
std::vector<PlaneCut> dissection() {
  return {plane(Vec3(0.32, 0.2, 0.2), Vec3(1, 0.3, -0.1)), plane(Vec3(0.3, 0.21, 0.2), Vec3(-0.2, 1, 0.1)),
          plane(Vec3(0.002, 0, 0), Vec3(1, 1, 1)), plane(Vec3(0.001, 0, 0), Vec3(1, 1, 1))};
}

TEST(FreeFall, IsExactForTheWholeBody) { EXPECT_LT(errorOfFall({}, {}), FALL_TOLERANCE); }

TEST(FreeFall, IsExactForEveryPieceCutInFlight) { EXPECT_LT(errorOfFall({}, dissection()), FALL_TOLERANCE); }

TEST(FreeFall, IsExactWithConsistentMass) {
  RigSettings settings;
  settings.mass = Mass::CONSISTENT;
  // Here a fragment spins as its own size r lets it, so rounding turns it by (h/r)² more: h/r is up to 200.
  EXPECT_LT(errorOfFall(settings, dissection()), 1e3 * FALL_TOLERANCE);
}

TEST(FreeFall, IsExactWithoutWarping) {
  RigSettings settings;
  settings.warping = false;
  EXPECT_LT(errorOfFall(settings, dissection()), FALL_TOLERANCE);
}

TEST(FreeFall, StiffnessDampingDoesNotBrakeIt) {
  RigSettings settings;
  settings.material.stiffness_damping = 0.1;
  EXPECT_LT(errorOfFall(settings, dissection()), FALL_TOLERANCE);
}

TEST(FreeFall, MassDampingBrakesItAsBackwardEulerDoes) {
  RigSettings settings;
  settings.material.mass_damping = 3;
  settings.conditions.gravity = GRAVITY;
  Rig rig(block({3, 2, 2}, Vec3(0.6, 0.4, 0.4)), settings);
  for (const PlaneCut& cut : dissection()) rig.cut(cut);
  Vec3 v = Vec3::Zero();
  for (int n = 0; n < 30; ++n) {
    ASSERT_TRUE(rig.advance());
    v = (v + GRAVITY * rig.time_step) / (1 + 3 * rig.time_step);
    for (const Vec3& velocity : rig.motion.v) ASSERT_LT((velocity - v).norm(), FALL_TOLERANCE * v.norm());
  }
}

// A small clamped block, cut part of the way, that swings in one of its modes of K φ = ω² M φ.
class Mode : public ::testing::Test {
 protected:
  // `which`: of the modes in the order of their frequency.
  void swing(RigSettings settings, double phase_step, int which) {
    settings.warping = false;
    settings.conditions.clamps = {{slab(0, 0), Vec3::Zero()}};
    const CutBlock probe(settings);
    copies_ = probe.freeCopies();
    const Eigen::MatrixXd K = systemMatrix(probe.step.assembly(), {0, 1}, copies_);
    M_ = systemMatrix(probe.step.assembly(), {1, 0}, copies_);
    const Eigen::GeneralizedSelfAdjointEigenSolver<Eigen::MatrixXd> modes(K, M_);
    omega_ = std::sqrt(modes.eigenvalues()[which]);
    mode_ = modes.eigenvectors().col(which);
    settings.solver.time_step = phase_step / omega_;
    rig_ = std::make_unique<CutBlock>(settings);
    for (std::size_t i = 0; i < copies_.size(); ++i) rig_->motion.x[copies_[i]] += mode_.segment<3>(3 * i);
  }

  struct CutBlock : Rig {
    explicit CutBlock(const RigSettings& settings) : Rig(block({3, 2, 2}, Vec3(0.6, 0.4, 0.4)), settings) {
      cut(rectangle(Vec3(0.6, 0.2, 0.23), Vec3(0, 0.1, 1), Vec3::UnitX(), 0.6, 0));
      EXPECT_EQ(pieces(), 1);
      EXPECT_GT(mesh.numCopies(), 36);
    }
  };

  // The mode's amplitude and velocity over ω, and what lies outside the mode.
  struct State {
    double q, p, rest;
  };
  State state() const {
    const std::vector<Vec3> u = rig_->displacements();
    Eigen::VectorXd x(3 * copies_.size()), v(3 * copies_.size());
    for (std::size_t i = 0; i < copies_.size(); ++i) {
      x.segment<3>(3 * i) = u[copies_[i]];
      v.segment<3>(3 * i) = rig_->motion.v[copies_[i]];
    }
    const double q = mode_.dot(M_ * x), p = mode_.dot(M_ * v) / omega_;
    const Eigen::VectorXd left = x - q * mode_, moving = v / omega_ - p * mode_;
    return {q, p, std::sqrt(left.dot(M_ * left) + moving.dot(M_ * moving))};
  }

  std::unique_ptr<Rig> rig_;
  std::vector<int> copies_;
  Eigen::MatrixXd M_;
  Eigen::VectorXd mode_;
  double omega_ = 0;
};

// Modes are known to about 1e-12 of the largest, and rounding grows little in 20 steps.
constexpr double MODE_TOLERANCE = 1e-9;

TEST_F(Mode, UndampedDecaysAsBackwardEulerDoes) {
  for (const Mass mass : {Mass::LUMPED, Mass::CONSISTENT})
    for (const double w : {0.1, 1.0, 5.0}) {
      RigSettings settings;
      settings.mass = mass;
      swing(settings, w, 2);
      for (int n = 1; n <= 20; ++n) {
        const State before = state();
        ASSERT_TRUE(rig_->advance());
        const State after = state();
        const double decay = 1 / std::sqrt(1 + w * w);
        EXPECT_NEAR(std::hypot(after.q, after.p) / std::hypot(before.q, before.p), decay, MODE_TOLERANCE);
        // In the plane of q and v/ω a step turns by atan(ωΔt).
        EXPECT_NEAR(after.q, (before.q + w * before.p) / (1 + w * w), MODE_TOLERANCE * std::hypot(before.q, before.p));
        EXPECT_LT(after.rest, MODE_TOLERANCE);
        if (std::hypot(after.q, after.p) < 1e-3) break;  // where rounding of positions shows
      }
    }
}

TEST_F(Mode, DampingFollowsTheScalarRecursion) {
  RigSettings settings;
  settings.material.mass_damping = 7;
  settings.material.stiffness_damping = 2e-3;
  swing(settings, 0.3, 1);
  const double dt = rig_->time_step;
  double q = 1, v = 0;
  for (int n = 0; n < 20; ++n) {
    ASSERT_TRUE(rig_->advance());
    const double c = 7 + 2e-3 * omega_ * omega_, k = omega_ * omega_;
    v += dt * (-c * v - k * q - dt * k * v) / (1 + dt * c + dt * dt * k);
    q += dt * v;
    EXPECT_NEAR(state().q, q, MODE_TOLERANCE);
    EXPECT_NEAR(state().p, v / omega_, MODE_TOLERANCE);
  }
}

// Rates at which the amplitude of an underdamped mode decays: (α + β ω²)/2, and ω²Δt/2 from backward Euler.
TEST_F(Mode, DampingRatesAreThoseOfMassAndStiffness) {
  for (const bool by_mass : {true, false}) {
    RigSettings settings;
    swing(settings, 0.002, 0);
    const double ratio = 0.01;
    const int steps = 12566;  // four periods, after which the ripple of the energy within a period is over
    settings.material.mass_damping = by_mass ? 2 * ratio * omega_ : 0;
    settings.material.stiffness_damping = by_mass ? 0 : 2 * ratio / omega_;
    swing(settings, 0.002, 0);
    for (int n = 0; n < steps; ++n) ASSERT_TRUE(rig_->advance());
    const State end = state();
    const double rate = -std::log(std::hypot(end.q, end.p)) / (omega_ * steps * rig_->time_step);
    EXPECT_NEAR(rate, ratio + 0.001, 0.02 * ratio);
  }
}

// Angular frequency [rad/s] of the slowest mode of a slender cantilever of n × n cells across, by inverse iteration.
double slowestMode(int n, double length, double height, const Material& material) {
  RigSettings settings;
  settings.material = material;
  settings.conditions.clamps = {{slab(0, 0), Vec3::Zero()}};
  const int along = static_cast<int>(std::lround(length / height)) * n;
  const Rig rig(block({along, n, n}, Vec3(length, height, height)), settings);
  const std::vector<int> copies = rig.freeCopies();
  const Eigen::SparseMatrix<double> K = systemMatrix(rig.step.assembly(), {0, 1}, copies);
  const Eigen::SparseMatrix<double> M = systemMatrix(rig.step.assembly(), {1, 0}, copies);
  const Eigen::SimplicialLDLT<Eigen::SparseMatrix<double>> inverse(K);
  Eigen::VectorXd mode(K.rows());
  for (std::size_t i = 0; i < copies.size(); ++i) {
    const double x = rig.mesh.mesh().nodes[rig.mesh.copyNode(copies[i])].x();
    mode.segment<3>(3 * i) = Vec3(0, 0.3, 1) * x * x;
  }
  for (int i = 0; i < 30; ++i) mode = inverse.solve(M * mode).normalized();
  return std::sqrt(mode.dot(K * mode) / mode.dot(M * mode));
}

// A bar of L/h = 10 with ν = 0. Linear tetrahedra raise the frequency by O(h²), which extrapolation takes off; what
// shear and rotary inertia take from it, which Euler and Bernoulli leave out, is about (1.8751 h/L)²/2 = 2 %.
void checkCantilever(const std::vector<int>& cells, double finest_bound, double extrapolated_bound) {
  const Material material = {1e6, 0, 1000, 0, 0};
  const double L = 1, h = 0.1;
  const double euler_bernoulli =
      1.8751 * 1.8751 * std::sqrt(material.young_modulus * h * h / 12 / (material.density * L * L * L * L));
  std::vector<double> error;
  for (int n : cells) {
    error.push_back(slowestMode(n, L, h, material) / euler_bernoulli - 1);
    ::testing::Test::RecordProperty("error_" + std::to_string(n), std::to_string(error.back()));
  }
  const double fine = error[error.size() - 1], coarse = error[error.size() - 2];
  const double extrapolated = fine + (fine - coarse) / 3;
  ::testing::Test::RecordProperty("error_extrapolated", std::to_string(extrapolated));
  EXPECT_LT(std::abs(fine), finest_bound);
  EXPECT_LT(std::abs(extrapolated), extrapolated_bound);
}

TEST(CantileverFrequency, ApproachesEulerBernoulli) { checkCantilever({2, 4}, 0.1, 0.03); }
TEST(CantileverFrequency, FullApproachesEulerBernoulli) { checkCantilever({2, 4, 8}, 0.03, 0.015); }

// A free block thrown with random velocities and cut in flight.
struct Thrown : Rig {
  Thrown(const RigSettings& settings, double speed) : Rig(block({3, 2, 2}, Vec3(0.6, 0.4, 0.4)), settings) {
    motion.v = randomVectors(motion.v.size(), speed, 7);
  }
};

constexpr std::pair<Mass, Pressure> DISCRETISATIONS[] = {
    {Mass::LUMPED, Pressure::ELEMENT}, {Mass::CONSISTENT, Pressure::ELEMENT}, {Mass::LUMPED, Pressure::AVERAGED}};

TEST(FreeFlight, ConservesMomentum) {
  for (const auto& [mass, pressure] : DISCRETISATIONS)
    for (const bool warping : {false, true}) {
      RigSettings settings;
      settings.mass = mass;
      settings.pressure = pressure;
      settings.warping = warping;
      settings.material.stiffness_damping = 1e-3;
      Thrown rig(settings, 1);
      const Vec3 momentum = rig.momentum();
      const double scale = 96 * 1;  // the body's mass at 1 m/s
      const std::vector<PlaneCut> cuts = dissection();
      for (int n = 0; n < 40; ++n) {
        if (n % 10 == 5) {
          rig.cut(cuts[n / 10]);
          EXPECT_LT((rig.momentum() - momentum).norm(), 1e-12 * scale);
        }
        ASSERT_TRUE(rig.advance());
        // Rounding of the forces, E ε A Δt, adds up.
        EXPECT_LT((rig.momentum() - momentum).norm(), 1e-11 * scale);
      }
    }
}

// Largest growth of the energy in one of 200 steps, relative to what was there at first. Cuts leave it as it is,
// or add to it where they part a patch that averages the pressure.
double energyGrowth(const RigSettings& settings) {
  Thrown rig(settings, 1);
  const std::vector<PlaneCut> cuts = dissection();
  double energy = rig.energy(), growth = 0;
  const double scale = energy;
  for (int n = 0; n < 200; ++n) {
    if (n % 50 == 25) {
      rig.cut(cuts[n / 50]);
      const double more = settings.pressure == Pressure::AVERAGED ? 1e-3 * scale : 0;
      EXPECT_GT(rig.energy(), energy - 1e-12 * scale) << "cut before step " << n;
      EXPECT_LT(rig.energy(), energy + more + 1e-12 * scale) << "cut before step " << n;
      energy = rig.energy();
    }
    EXPECT_TRUE(rig.advance());
    growth = std::max(growth, (rig.energy() - energy) / scale);
    energy = rig.energy();
  }
  EXPECT_LT(energy, scale);
  return growth;
}

TEST(FreeFlight, EnergyNeverGrowsUndampedAndUnloaded) {
  for (const auto& [mass, pressure] : DISCRETISATIONS) {
    RigSettings settings;
    settings.mass = mass;
    settings.pressure = pressure;
    settings.warping = false;
    EXPECT_LT(energyGrowth(settings), 1e-12);
  }
}

// A warped step is linear with the rotations of its start, which it holds while the body turns on. So its energy is
// not bounded by theory; it must not grow visibly.
TEST(FreeFlight, EnergyHardlyGrowsWarped) {
  for (const auto& [mass, pressure] : DISCRETISATIONS) {
    RigSettings settings;
    settings.mass = mass;
    settings.pressure = pressure;
    const double growth = energyGrowth(settings);
    RecordProperty(std::string("growth") + (mass == Mass::LUMPED ? "_lumped" : "_consistent") +
                       (pressure == Pressure::AVERAGED ? "_averaged" : ""),
                   std::to_string(1e9 * growth) + "e-9");
    EXPECT_LT(growth, 1e-5);
  }
}

TEST(Cantilever, SwingsAlikeWarpedAndNotWhereItMovesLittle) {
  RigSettings settings;
  settings.conditions.clamps = {{slab(0, 0), Vec3::Zero()}};
  settings.conditions.loads = {{slab(0, 1), Vec3(0, 0, 0.1), 0}};
  Rig warped(block({10, 2, 2}, Vec3(1, 0.2, 0.2)), settings);
  settings.warping = false;
  Rig linear(block({10, 2, 2}, Vec3(1, 0.2, 0.2)), settings);
  double moved = 0, apart = 0;
  for (int n = 0; n < 100; ++n) {
    ASSERT_TRUE(warped.advance() && linear.advance());
    moved = std::max(moved, largest(linear.displacements()));
    apart = std::max(apart, largestDifference(warped.motion.x, linear.motion.x));
  }
  // They part by the strain and rotation, here some 1e-5.
  EXPECT_GT(moved, 1e-6);
  EXPECT_LT(apart, 1e-3 * moved);
}

}  // namespace
}  // namespace incision
