#include <gtest/gtest.h>

#include "support/given_springs.h"

namespace incision {
namespace {

RigSettings fallingBlock(Method method) {
  RigSettings settings;
  settings.solver = {0.01, method, 1e-6, 1};
  settings.conditions.gravity = Vec3(0, 0, -9.81);
  settings.conditions.clamps = {{slab(0, 0), Vec3::Zero()}};
  return settings;
}

/// A block whose far ends springs join as long as they are on.
struct SpannedBlock : Rig {
  explicit SpannedBlock(Method method)
      : Rig(block({16, 4, 4}, Vec3(1, 0.25, 0.25)), fallingBlock(method)),
        coupler(springs(),
                [this](Span<const Vec3>, Span<Spring> springs) {
                  for (Spring& spring : springs) spring.stiffness = (is_on ? 1e3 : 0.0) * Mat3::Identity();
                }),
        couplers({&coupler}) {}

  std::vector<Spring> springs() const {
    std::vector<Spring> list;
    for (int k = 0; k < 20; ++k) list.push_back(springFrom(30 + k));
    return list;
  }

  Spring springFrom(int copy) const {
    Spring spring;
    spring.add(copy, 1);
    spring.add(mesh.numCopies() - copy, -1);
    return spring;
  }

  void take(int steps) {
    for (int k = 0; k < steps; ++k) ASSERT_TRUE(advanceWith(this, &couplers));
  }

  bool is_on = true;
  GivenSprings coupler;
  Couplers couplers;
};

class SolverMemoryOf : public ::testing::TestWithParam<Method> {};

// What springs were there decides on how a solver rounds, also when they are gone.
TEST_P(SolverMemoryOf, StepsGoOnFromItToTheLastDigit) {
  SpannedBlock one(GetParam()), other(GetParam());
  one.take(3);
  one.is_on = other.is_on = false;
  one.take(1);
  const ImplicitStep::Memory kept = one.step.keep();
  EXPECT_FALSE(kept.solver.blocks.empty() && kept.solver.coarse_blocks.empty());
  other.motion = one.motion;
  other.time = one.time;
  other.step.recall(kept);
  for (int k = 0; k < 5; ++k) {
    one.take(1);
    other.take(1);
    ASSERT_EQ(other.motion.v, one.motion.v) << k;
    const SolverMemory memory = other.step.keep().solver, expected = one.step.keep().solver;
    EXPECT_EQ(memory.blocks, expected.blocks);
    EXPECT_EQ(memory.idle, expected.idle);
    EXPECT_EQ(memory.coarse_blocks, expected.coarse_blocks);
  }
}

INSTANTIATE_TEST_SUITE_P(Methods, SolverMemoryOf, ::testing::Values(Method::DIRECT, Method::ITERATIVE));

}  // namespace
}  // namespace incision
