#include <gtest/gtest.h>

#include <cmath>
#include <ostream>
#include <string>

#include "support/rig.h"

namespace incision {
namespace {

// A clamped, loaded and falling block under one method.
struct Case {
  const char* name;
  Material material;
  Mass mass = Mass::LUMPED;
  double time_step = 0.01;
  std::vector<PlaneCut> cuts = {};
  double size = 0.125;  // radius of gyration of the smallest piece, where mass knows it; else an element's [m]
  Pressure pressure = Pressure::ELEMENT;
};

RigSettings settingsOf(const Case& of, Method method) {
  RigSettings settings;
  settings.material = of.material;
  settings.mass = of.mass;
  settings.pressure = of.pressure;
  settings.solver = {of.time_step, method, 1e-8, 1};
  settings.conditions.gravity = Vec3(0, 0, -9.81);
  settings.conditions.clamps = {{slab(0, 0), Vec3::Zero()}};
  settings.conditions.loads = {{slab(0, 1), Vec3(1000, 500, 0), 0}};
  return settings;
}

struct LoadedBlock : Rig {
  LoadedBlock(const Case& of, const RigSettings& settings) : Rig(block({8, 4, 4}, Vec3(1, 0.5, 0.5)), settings) {
    for (const PlaneCut& plane : of.cuts) EXPECT_TRUE(cut(plane).changed());
  }
};

// ‖v − w‖ of each piece relative to ‖v‖ of the same piece, in the norm of its mass; the worst of them. What has come to
// rest moves by rounding alone, so ‖v‖ is the largest that was seen of the piece, in `squares`.
double worstOfPieces(const Rig& rig, const std::vector<Vec3>& v, const std::vector<Vec3>& w,
                     std::vector<double>* squares) {
  int pieces = 0;
  const std::vector<int> piece = rig.mesh.copyPieces(&pieces);
  std::vector<Vec3> e = v, Me, Mv;
  for (std::size_t c = 0; c < e.size(); ++c) e[c] -= w[c];
  rig.step.assembly().multiplyMass(e, &Me);
  rig.step.assembly().multiplyMass(v, &Mv);
  std::vector<double> error(pieces, 0), square(pieces, 0);
  for (std::size_t c = 0; c < e.size(); ++c) {
    error[piece[c]] += e[c].dot(Me[c]);
    square[piece[c]] += v[c].dot(Mv[c]);
  }
  squares->resize(pieces, 0);
  double worst = 0;
  for (int s = 0; s < pieces; ++s) {
    (*squares)[s] = std::max((*squares)[s], square[s]);
    EXPECT_GT((*squares)[s], 0);
    worst = std::max(worst, std::sqrt(error[s] / (*squares)[s]));
  }
  return worst;
}

const Material SOFT = {1e5, 0.4, 1000, 0, 1e-3};
const PlaneCut HALVES = plane(Vec3(0.48, 0.25, 0.25), Vec3(1, 0.2, 0.1));
const PlaneCut SLIT = rectangle(Vec3(1, 0.27, 0.25), Vec3(0.1, 1, 0.1), Vec3::UnitX(), 1.2, 0);
// A corner with a share of some 1e-6 of its element, far from the clamp.
const PlaneCut FRAGMENT = plane(Vec3(0.998, 0.5, 0.5), Vec3::Ones());
// Ten parts and more in an element.
std::vector<PlaneCut> shreds() {
  std::vector<PlaneCut> cuts;
  for (int k = 0; k < 4; ++k) cuts.push_back(plane(Vec3(0.6 + 0.013 * k, 0.25, 0.25), Vec3(1, 0.1 * k, -0.1)));
  cuts.push_back(plane(Vec3(0.6, 0.26, 0.25), Vec3(0.1, 1, 0.2)));
  return cuts;
}

void PrintTo(const Case& of, std::ostream* out) { *out << of.name; }

class BothMethods : public ::testing::TestWithParam<Case> {};

// What a residual of 1e-8 may leave in the velocities: more by the condition number of M + Δt C + Δt² K scaled to a
// unit diagonal, some E (Δt² + β Δt) / (ρ size²).
double allowedError(const Case& of) {
  const Material& m = of.material;
  const double dt = of.time_step;
  return 3e-8 * (10 + m.young_modulus * (dt * dt + m.stiffness_damping * dt) / (m.density * of.size * of.size));
}

// From the same state each time, so that one step's error is seen.
TEST_P(BothMethods, FindTheSameVelocitiesInEveryPiece) {
  LoadedBlock direct(GetParam(), settingsOf(GetParam(), Method::DIRECT));
  LoadedBlock iterative(GetParam(), settingsOf(GetParam(), Method::ITERATIVE));
  double worst = 0;
  std::vector<double> squares;
  for (int n = 0; n < 5; ++n) {
    iterative.motion = direct.motion;
    ASSERT_TRUE(direct.advance());
    ASSERT_TRUE(iterative.advance());
    // Rounding, which is all that a direct solve leaves, ends an iteration where its bound is: some hundred times
    // higher.
    EXPECT_LE(iterative.step.stats().residual, std::max(1e-8, 200 * direct.step.stats().residual));
    // Where rounding keeps the iteration from its tolerance it may end in a direct solve; later guesses may do alone.
    if (n == 0 && GetParam().material.young_modulus < 1e10) {
      EXPECT_GT(iterative.step.stats().iterations, 0);
    }
    EXPECT_EQ(direct.step.stats().iterations, 0);
    worst = std::max(worst, worstOfPieces(direct, direct.motion.v, iterative.motion.v, &squares));
  }
  RecordProperty("error", std::to_string(worst * 1e8) + "e-8");
  RecordProperty("iterations", iterative.step.stats().iterations);
  EXPECT_LT(worst, allowedError(GetParam()));
}

TEST_P(BothMethods, GiveTheSameBitsWhateverTheThreads) {
  for (const Method method : {Method::DIRECT, Method::ITERATIVE}) {
    RigSettings settings = settingsOf(GetParam(), method);
    LoadedBlock one(GetParam(), settings);
    for (int n = 0; n < 3; ++n) ASSERT_TRUE(one.advance());
    for (const int threads : {2, 3}) {
      settings.solver.threads = threads;
      LoadedBlock many(GetParam(), settings);
      for (int n = 0; n < 3; ++n) ASSERT_TRUE(many.advance());
      EXPECT_EQ(one.motion.x, many.motion.x);
      EXPECT_EQ(one.motion.v, many.motion.v);
    }
  }
}

std::string caseName(const ::testing::TestParamInfo<Case>& test) { return test.param.name; }

INSTANTIATE_TEST_SUITE_P(
    Solvers, BothMethods,
    ::testing::Values(Case{"Uncut", SOFT}, Case{"Halves", SOFT, Mass::LUMPED, 0.01, {HALVES}},
                      Case{"Slit", SOFT, Mass::LUMPED, 0.01, {SLIT}},
                      Case{"Fragment", SOFT, Mass::LUMPED, 0.01, {HALVES, FRAGMENT}},
                      Case{"Shreds", SOFT, Mass::LUMPED, 0.01, shreds()},
                      Case{"Consistent", SOFT, Mass::CONSISTENT, 0.01, {HALVES}},
                      Case{"ConsistentFragment", SOFT, Mass::CONSISTENT, 0.01, {HALVES, FRAGMENT}, 4e-4},
                      Case{"Stiff1e9", {1e9, 0.3, 1000, 0, 0}, Mass::LUMPED, 0.01, {HALVES}},
                      Case{"Stiff1e12", {1e12, 0.3, 1000, 0, 0}, Mass::LUMPED, 0.01, {HALVES}},
                      Case{"Incompressible", {1e5, 0.4999, 1000, 0, 0}, Mass::LUMPED, 0.01, {HALVES}},
                      Case{"Averaged", SOFT, Mass::LUMPED, 0.01, {SLIT, FRAGMENT}, 0.125, Pressure::AVERAGED},
                      Case{"AveragedShreds", SOFT, Mass::CONSISTENT, 0.01, shreds(), 0.125, Pressure::AVERAGED},
                      Case{"AveragedIncompressible",
                           {1e5, 0.4999, 1000, 0, 0},
                           Mass::LUMPED,
                           0.01,
                           {HALVES},
                           0.125,
                           Pressure::AVERAGED},
                      Case{"ShortStep", SOFT, Mass::LUMPED, 1e-5, {HALVES, FRAGMENT}},
                      Case{"LongStep", {1e5, 0.4, 1000, 1, 0}, Mass::LUMPED, 1, {SLIT}}),
    caseName);

TEST(IterativeSolver, SolvesAFragmentAtRestBesideAFastBody) {
  Case of{"", SOFT, Mass::LUMPED, 0.01, {FRAGMENT}};
  LoadedBlock direct(of, settingsOf(of, Method::DIRECT)), iterative(of, settingsOf(of, Method::ITERATIVE));
  int pieces = 0;
  const std::vector<int> piece = direct.mesh.copyPieces(&pieces);
  ASSERT_EQ(pieces, 2);
  for (int c = 0; c < direct.mesh.numCopies(); ++c)
    direct.motion.v[c] = direct.step.held()[c] >= 0 || piece[c] != piece[0] ? Vec3::Zero() : Vec3(0, 100, 0);
  iterative.motion = direct.motion;
  ASSERT_TRUE(direct.advance() && iterative.advance());
  std::vector<double> squares;
  EXPECT_LT(worstOfPieces(direct, direct.motion.v, iterative.motion.v, &squares), allowedError(of));
}

TEST(Solvers, WithoutWarpingAKeptFactorIsAsGoodAsAFreshOne) {
  for (const Method method : {Method::DIRECT, Method::ITERATIVE}) {
    const Case of{"", SOFT, Mass::LUMPED, 0.01, {SLIT}};
    RigSettings settings = settingsOf(of, method);
    settings.warping = false;
    settings.solver.tolerance = 1e-10;
    LoadedBlock kept(of, settings);
    for (int n = 0; n < 10; ++n) {
      LoadedBlock fresh(of, settings);
      fresh.motion = kept.motion;
      ASSERT_TRUE(kept.advance() && fresh.advance());
      EXPECT_LT(largestDifference(kept.motion.v, fresh.motion.v), 1e-7 * largest(fresh.motion.v));
    }
  }
}

TEST(Solvers, AKeptFactorIsDroppedWhenTheStepOrTheTopologyChanges) {
  const Case of{"", SOFT, Mass::LUMPED, 0.01, {}};
  RigSettings settings = settingsOf(of, Method::DIRECT);
  settings.warping = false;
  LoadedBlock kept(of, settings);
  const auto expectAsFresh = [&] {
    LoadedBlock fresh(of, settings);
    for (const PlaneCut& cut : kept.mesh.numCracks() > 0 ? std::vector<PlaneCut>{HALVES} : std::vector<PlaneCut>{})
      fresh.cut(cut);
    fresh.motion = kept.motion;
    fresh.time_step = kept.time_step;
    ASSERT_TRUE(kept.advance() && fresh.advance());
    EXPECT_EQ(kept.motion.v, fresh.motion.v);
  };
  expectAsFresh();
  kept.time_step = 0.005;
  expectAsFresh();
  kept.time_step = 0.01;
  expectAsFresh();
  kept.motion.x = restPositions(kept.mesh);  // so that the same plane cuts the same parts
  kept.cut(HALVES);
  expectAsFresh();
}

TEST(Solvers, AutoIsDirectForSmallBodiesAndIterativeForLarge) {
  RigSettings settings;
  settings.conditions.gravity = Vec3(0, 0, -1);
  settings.conditions.clamps = {{slab(0, 0), Vec3::Zero()}};
  settings.solver.method = Method::AUTO;
  Rig small(block({2, 2, 2}, Vec3::Ones()), settings), large(block({10, 10, 10}, Vec3::Ones()), settings);
  ASSERT_TRUE(small.advance() && large.advance());
  EXPECT_EQ(small.step.stats().iterations, 0);
  EXPECT_GT(large.step.stats().iterations, 0);
}

// Only its mass resists the rigid motion of a free piece. Its copies are thrown apart, so that the stiffness has all
// the right-hand side; Δt²E/(ρh²) is up to 1e13, beyond which even double has no digits left for the mass.
TEST(Solvers, AFreePieceKeepsItsMomentumHoweverStiff) {
  for (const Method method : {Method::DIRECT, Method::ITERATIVE})
    for (const double young_modulus : {1e4, 1e9, 1e12, 1e14}) {
      RigSettings settings;
      settings.material.young_modulus = young_modulus;
      settings.solver = {1, method, 1e-6, 1};
      Rig rig(block({6, 4, 4}, Vec3(0.6, 0.4, 0.4)), settings);
      rig.cut(plane(Vec3(0.31, 0.2, 0.2), Vec3(1, 0.3, 0.1)));
      rig.motion.v = randomVectors(rig.motion.v.size(), 1e-3, 7);
      const Vec3 momentum = rig.momentum();
      const double energy = rig.kineticEnergy();
      for (int n = 0; n < 10; ++n) {
        ASSERT_TRUE(rig.advance());
        EXPECT_LT((rig.momentum() - momentum).norm(), 0.1 * momentum.norm()) << young_modulus;
        EXPECT_LT(rig.kineticEnergy(), energy) << young_modulus;
      }
    }
}

TEST(Solvers, ABodyHeldEverywhereHasNothingToSolve) {
  for (const Method method : {Method::DIRECT, Method::ITERATIVE}) {
    RigSettings settings;
    settings.solver.method = method;
    settings.conditions.gravity = Vec3(0, 0, -1);
    settings.conditions.clamps = {{{Vec3::Constant(-1), Vec3::Constant(2)}, Vec3(1, 2, 3)}};
    Rig rig(block({2, 2, 2}, Vec3::Ones()), settings);
    rig.cut(plane(Vec3::Constant(0.3), Vec3::UnitX()));
    ASSERT_TRUE(rig.advance());
    for (const Vec3& v : rig.motion.v) EXPECT_EQ(v, Vec3(1, 2, 3));
  }
}

TEST(Solvers, AValueThatIsNotFiniteFailsTheStepAndLeavesTheState) {
  for (const Method method : {Method::DIRECT, Method::ITERATIVE}) {
    RigSettings settings;
    settings.solver.method = method;
    settings.conditions.gravity = Vec3(0, 0, 1e308);
    settings.conditions.loads = {{slab(0, 1), Vec3(1e308, 0, 0), 0}};
    settings.material.density = 1e300;
    Rig rig(block({2, 2, 2}, Vec3::Ones()), settings);
    const Motion before = rig.motion;
    EXPECT_FALSE(rig.advance());
    EXPECT_EQ(rig.motion.x, before.x);
    EXPECT_EQ(rig.motion.v, before.v);
  }
}

}  // namespace
}  // namespace incision
