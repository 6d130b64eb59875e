#include "incision/solver/spring.h"

#include <gtest/gtest.h>

#include <random>

#include "incision/solver/direct_solver.h"
#include "support/given_springs.h"

namespace incision {
namespace {

// Two halves of a block and a corner of it, thrown apart.
struct ThrownPieces : Rig {
  explicit ThrownPieces(Method method, double tolerance = 1e-10)
      : Rig(block({8, 4, 4}, Vec3(1, 0.5, 0.5)), settings(method, tolerance)) {
    EXPECT_TRUE(cut(plane(Vec3(0.48, 0.25, 0.25), Vec3(1, 0.2, 0.1))).changed());
    EXPECT_TRUE(cut(plane(Vec3(0.9, 0.45, 0.45), Vec3::Ones())).changed());
    EXPECT_EQ(pieces(), 3);
    motion.v = randomVectors(motion.x.size(), 0.1, 5);
  }
  static RigSettings settings(Method method, double tolerance) {
    RigSettings settings;
    settings.material = {1e5, 0.4, 1000, 0, 1e-3};
    settings.solver = {0.01, method, tolerance, 1};
    return settings;
  }
};

// Springs between any copies, each a hundred times as stiff across as along, and stretched at first.
std::vector<Spring> randomSprings(const Rig& rig, double stiffness) {
  std::mt19937 generator(7);
  std::uniform_int_distribution<int> anyCopy(0, rig.mesh.numCopies() - 1);
  const std::vector<Vec3> directions = randomVectors(40, 1, 11);
  std::vector<Spring> springs;
  for (const Vec3& n : directions) {
    Spring spring;
    for (int i = 0; i < 4; ++i) spring.add(anyCopy(generator), 0.25);
    for (int i = 0; i < 4; ++i) spring.add(anyCopy(generator), -0.25);
    const Mat3 across = n.normalized() * n.normalized().transpose();
    spring.stiffness = stiffness * (across + 0.01 * (Mat3::Identity() - across));
    spring.force = 10 * n;
    springs.push_back(spring);
  }
  return springs;
}

bool advance(Rig* rig, const std::vector<Spring>& springs) {
  GivenSprings given(springs);
  Couplers couplers({&given});
  return advanceWith(rig, &couplers);
}

// An element here is about 1e5 Pa × 0.125 m = 1e4 N/m stiff.
class Springs : public ::testing::TestWithParam<double> {};

// The direct solver's residual comes from the forces, not from the matrix.
TEST_P(Springs, AreInTheMatrixAsInTheForces) {
  ThrownPieces rig(Method::DIRECT);
  ASSERT_TRUE(advance(&rig, randomSprings(rig, GetParam())));
  EXPECT_LT(rig.step.stats().residual, 1e-12);
}

TEST_P(Springs, GiveTheSameVelocitiesByIteration) {
  ThrownPieces direct(Method::DIRECT), iterative(Method::ITERATIVE);
  const auto springs = randomSprings(direct, GetParam());
  for (int n = 0; n < 3; ++n) {
    iterative.motion = direct.motion;
    ASSERT_TRUE(advance(&direct, springs));
    ASSERT_TRUE(advance(&iterative, springs));
    EXPECT_GT(iterative.step.stats().iterations, 0);
    EXPECT_LE(iterative.step.stats().residual, 1e-10);
    EXPECT_LT(largestDifference(direct.motion.v, iterative.motion.v), 1e-7 * largest(direct.motion.v));
  }
}

TEST_P(Springs, KeepTheMomentum) {
  ThrownPieces rig(Method::DIRECT);
  const Vec3 before = rig.momentum();
  for (int n = 0; n < 10; ++n) ASSERT_TRUE(advance(&rig, randomSprings(rig, GetParam())));
  EXPECT_LT((rig.momentum() - before).norm(), 1e-10 * before.norm());
}

INSTANTIATE_TEST_SUITE_P(Spring, Springs, ::testing::Values(1e2, 1e4, 1e6));

TEST(Spring, ThatIsGoneLeavesNothingBehind) {
  for (const Method method : {Method::DIRECT, Method::ITERATIVE}) {
    ThrownPieces held(method), free(method);
    ASSERT_TRUE(advance(&held, randomSprings(held, 1e6)));
    ASSERT_TRUE(free.advance());
    held.motion = free.motion;
    for (int n = 0; n < 3; ++n) {
      ASSERT_TRUE(advance(&held, {}));
      ASSERT_TRUE(free.advance());
    }
    EXPECT_LT(largestDifference(held.motion.v, free.motion.v), 1e-7 * largest(free.motion.v));
  }
}

// As from one surface sliding on another: what they have left must not fill the factor for good.
TEST(Spring, ThatMovesOnLeavesNoTrailInTheFactor) {
  const ThrownPieces rig(Method::DIRECT);
  const std::vector<int> none(rig.mesh.numCopies(), 0);
  DirectSolver solver;
  solver.systemChanged(rig.step.assembly(), {std::vector<bool>(none.size(), false), none, none, {}}, {1, 1e-4});
  solver.matrixChanged(rig.motion.x);
  const auto springs = randomSprings(rig, 1e4);
  ASSERT_TRUE(solver.springsChanged({springs[0]}, 0.01));
  const int of_one = solver.extraBlocks();
  ASSERT_GT(of_one, 10);
  for (const Spring& spring : springs) {
    ASSERT_TRUE(solver.springsChanged({spring}, 0.01));
    EXPECT_LE(solver.extraBlocks(), 3 * of_one);
  }
  for (int k = 0; k < 20; ++k) ASSERT_TRUE(solver.springsChanged({}, 0.01));
  EXPECT_GT(solver.extraBlocks(), 0);  // what bounces comes back
  for (int k = 0; k < 40; ++k) ASSERT_TRUE(solver.springsChanged({}, 0.01));
  EXPECT_EQ(solver.extraBlocks(), 0);
}

// Of a potential like that of a string, k (|y| − l)²/2 where it is taut: what acts at the end is what it pulls with
// there.
TEST(Spring, ActsAsItDoesAtTheEndOfTheStep) {
  for (const Method method : {Method::DIRECT, Method::ITERATIVE}) {
    ThrownPieces rig(method);
    std::vector<Spring> springs = randomSprings(rig, 1e4);
    std::vector<Vec3> start;
    for (const Spring& spring : springs) start.push_back(weightedSum(spring, rig.motion.x));
    constexpr double LENGTH = 0.4, STIFFNESS = 3e3;
    const auto pull = [&](const Vec3& y) -> Vec3 {
      return -STIFFNESS * std::max(0.0, y.norm() - LENGTH) * y.normalized();
    };
    GivenSprings given(springs, [&](Span<const Vec3> moved, Span<Spring> list) {
      for (int i = 0; i < moved.size(); ++i) {
        const Vec3 y = start[i] + moved[i];
        const double across = pull(y).norm() / y.norm();
        Mat3 K = across * Mat3::Identity();
        if (across > 0) K += (STIFFNESS - across) * y.normalized() * y.normalized().transpose();
        list[i].set(K, pull(y), moved[i]);
      }
    });
    Couplers couplers({&given});
    const Vec3 before = rig.momentum();
    ASSERT_TRUE(advanceWith(&rig, &couplers));
    EXPECT_TRUE(rig.step.stats().settled);
    EXPECT_GT(rig.step.stats().solves, 1);
    EXPECT_LT(rig.step.stats().solves, 12);
    Vec3 sum = Vec3::Zero();
    for (std::size_t i = 0; i < springs.size(); ++i) {
      double weights = 0;
      for (int k = 0; k < springs[i].count; ++k) weights += springs[i].weights[k];
      sum += rig.time_step * weights * pull(start[i] + given.moved()[i]);
    }
    EXPECT_LT((rig.momentum() - before - sum).norm(), 1e-3 * sum.norm() + 1e-9);
  }
}

#ifndef NDEBUG
TEST(SpringDeathTest, HasRoomForEightCopiesAndNoMore) {
  Spring spring;
  for (int copy = 0; copy < 8; ++copy) spring.add(copy, 1);
  spring.add(3, 1);
  EXPECT_EQ(spring.count, 8);
  EXPECT_DEATH(spring.add(8, 1), "");
}
#endif

}  // namespace
}  // namespace incision
