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
  GivenSprings given([&](const std::vector<Vec3>&, std::vector<Spring>* list) {
    *list = springs;
    return false;
  });
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

// Each solve is followed by a question, until the coupler is content.
TEST(Spring, IsUpdatedAfterEachSolve) {
  ThrownPieces rig(Method::DIRECT);
  const auto springs = randomSprings(rig, 1e4);
  std::vector<Vec3> v_last;
  int calls = 0;
  GivenSprings given([&](const std::vector<Vec3>& v_end, std::vector<Spring>* list) {
    list->assign(springs.begin(), springs.begin() + 10 * std::min(calls, 3));
    v_last = v_end;
    return ++calls < 4;
  });
  Couplers couplers({&given});
  ASSERT_TRUE(advanceWith(&rig, &couplers));
  EXPECT_EQ(calls, 4);
  EXPECT_EQ(largestDifference(v_last, rig.motion.v), 0);
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
