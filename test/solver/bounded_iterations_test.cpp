// A step that is ended by `solver.iterations` is what its iterations have made of it by then.
#include <gtest/gtest.h>

#include <cmath>

#include "support/rig.h"

namespace incision {
namespace {

const Material MATERIAL = {1e6, 0.4, 1000, 0, 1e-3};

RigSettings settingsWith(std::optional<int> iterations) {
  RigSettings settings;
  settings.material = MATERIAL;
  settings.solver = {0.01, Method::ITERATIVE, 1e-5, 1};
  settings.solver.iterations = iterations;
  settings.conditions.gravity = Vec3(0, 0, -9.81);
  settings.conditions.clamps = {{slab(0, 0), Vec3::Zero()}};
  settings.conditions.loads = {{slab(0, 1), Vec3(1000, 500, 0), 0}};
  return settings;
}

/// It has swung for five steps where `swinging` says so.
struct SwingingBlock : Rig {
  explicit SwingingBlock(const RigSettings& settings) : Rig(block({8, 4, 4}, Vec3(1, 0.5, 0.5)), settings) {}
};

Motion swinging(const RigSettings& settings) {
  SwingingBlock rig(settings);
  for (int n = 0; n < 5; ++n) EXPECT_TRUE(rig.advance());
  return rig.motion;
}

/// eᵀ A e, the error of velocities in the norm of the step's energy.
double energyOf(const Rig& rig, const Motion& start, const std::vector<Vec3>& e) {
  const double dt = rig.time_step, beta = MATERIAL.stiffness_damping;
  std::vector<Vec3> moved = start.x, before, after;
  for (std::size_t c = 0; c < e.size(); ++c) moved[c] += e[c];
  rig.step.assembly().elasticForces(start.x, &before);
  rig.step.assembly().elasticForces(moved, &after);
  double sum = 0;
  for (std::size_t c = 0; c < e.size(); ++c)
    sum += e[c].dot(rig.step.assembly().masses()[c] * e[c] + dt * (dt + beta) * (after[c] - before[c]));
  return sum;
}

TEST(BoundedIterations, BringTheStepNearerWithEachAndNeverFartherThanWithoutASolve) {
  const Motion start = swinging(settingsWith({}));
  RigSettings direct = settingsWith({});
  direct.solver.method = Method::DIRECT;
  SwingingBlock reference(direct);
  reference.motion = start;
  ASSERT_TRUE(reference.advance());
  const auto errorOf = [&](const std::vector<Vec3>& v) {
    std::vector<Vec3> e = v;
    for (std::size_t c = 0; c < e.size(); ++c) e[c] -= reference.motion.v[c];
    return energyOf(reference, start, e);
  };
  double last = errorOf(start.v);
  for (int most = 1; most <= 20; ++most) {
    SwingingBlock rig(settingsWith(most));
    rig.motion = start;
    ASSERT_TRUE(rig.advance());
    EXPECT_EQ(rig.step.stats().iterations, most);
    EXPECT_FALSE(rig.step.stats().settled);
    EXPECT_TRUE(rig.step.stats().cut_short);
    const double error = errorOf(rig.motion.v);
    EXPECT_LT(error, last) << "with " << most;
    last = error;
  }
}

TEST(BoundedIterations, ThatAreNeverReachedChangeNothing) {
  SwingingBlock free(settingsWith({})), bounded(settingsWith(1000));
  for (int n = 0; n < 10; ++n) {
    ASSERT_TRUE(free.advance() && bounded.advance());
    EXPECT_EQ(free.motion.x, bounded.motion.x);
    EXPECT_TRUE(bounded.step.stats().settled);
    EXPECT_FALSE(bounded.step.stats().cut_short);
  }
}

TEST(BoundedIterations, GiveTheSameBitsWhateverTheThreads) {
  const auto motionWith = [](int threads) {
    RigSettings settings = settingsWith(4);
    settings.solver.threads = threads;
    SwingingBlock rig(settings);
    for (int n = 0; n < 10; ++n) EXPECT_TRUE(rig.advance());
    return rig.motion.x;
  };
  EXPECT_EQ(motionWith(1), motionWith(2));
  EXPECT_EQ(motionWith(1), motionWith(3));
}

TEST(BoundedIterations, MeanNothingToAFactorisation) {
  RigSettings settings = settingsWith(1);
  settings.solver.method = Method::DIRECT;
  SwingingBlock rig(settings);
  ASSERT_TRUE(rig.advance());
  EXPECT_TRUE(rig.step.stats().settled);
}

}  // namespace
}  // namespace incision
