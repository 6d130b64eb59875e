#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <random>

#include "incision/solver/spring.h"
#include "support/given_springs.h"

namespace incision {
namespace {

RigSettings settings() {
  RigSettings settings;
  settings.material = {1e5, 0.3, 1000, 0, 1e-3};
  return settings;
}

/// Springs between the tool and any points of the body, about as stiff as an element is.
std::vector<Spring> springsTo(const Rig& rig, unsigned seed) {
  std::mt19937 generator(seed);
  std::uniform_int_distribution<int> anyCopy(0, rig.mesh.numCopies() - 1);
  std::vector<Spring> springs;
  for (const Vec3& force : randomVectors(10, 100, seed)) {
    Spring spring;
    for (const double weight : {0.1, 0.2, 0.3, 0.4}) spring.add(anyCopy(generator), weight);
    spring.stiffness = 1e4 * (Mat3::Identity() + 1e-4 * force * force.transpose());
    spring.force = force;
    springs.push_back(spring);
  }
  return springs;
}

TEST(Wrench, IsAgainstTheImpulsesAndTheirMoment) {
  Rig rig(block({2, 2, 2}, Vec3::Ones()), settings());
  const std::vector<Spring> springs = springsTo(rig, 1);
  const std::vector<Vec3> moved = randomVectors(springs.size(), 0.01, 2);
  std::vector<Vec3> forces(rig.motion.x.size(), Vec3::Zero());
  for (std::size_t i = 0; i < springs.size(); ++i) addShares(springs[i], springs[i].at(moved[i]), &forces);
  Wrench sum;
  for (std::size_t c = 0; c < forces.size(); ++c) {
    sum.force -= forces[c];
    sum.torque -= rig.motion.x[c].cross(forces[c]);
  }
  Wrench wrench;
  for (std::size_t i = 0; i < springs.size(); ++i) {
    const Wrench one = wrenchOf(springs[i].at(moved[i]), weightedSum(springs[i], rig.motion.x));
    wrench.force += one.force;
    wrench.torque += one.torque;
  }
  EXPECT_LT((wrench.force - sum.force).norm(), 1e-12 * sum.force.norm());
  EXPECT_LT((wrench.torque - sum.torque).norm(), 1e-12 * sum.torque.norm());
}

// Springs that never settle: the step ends somewhere between two solves.
TEST(Wrench, TakesTheMomentumThatTheBodyGainsWhereverTheStepEnds) {
  for (const bool alternate : {false, true}) {
    Rig rig(block({2, 2, 2}, Vec3::Ones()), settings());
    const std::vector<Spring> springs[2] = {springsTo(rig, 1), springsTo(rig, 2)};
    for (int n = 0; n < 5; ++n) {
      const Vec3 before = rig.momentum();
      int calls = 0;
      GivenSprings given(springs[0], [&](Span<const Vec3>, Span<Spring> list) {
        const std::vector<Spring>& other = springs[alternate ? calls % 2 : 0];
        for (int i = 0; i < list.size(); ++i) {
          list[i].force = other[i].force;
          list[i].stiffness = other[i].stiffness;
        }
        ++calls;
      });
      Couplers couplers({&given});
      ASSERT_TRUE(advanceWith(&rig, &couplers));
      EXPECT_EQ(rig.step.stats().settled, !alternate);
      const Vec3 impulse = -rig.time_step * given.felt().force;
      EXPECT_LT((rig.momentum() - before - impulse).norm(), 1e-10 * impulse.norm()) << alternate;
    }
  }
}

TEST(Wrench, GoesToTheCouplerWhoseSpringsGiveIt) {
  Rig rig(block({2, 2, 2}, Vec3::Ones()), settings());
  GivenSprings first(springsTo(rig, 1)), second(springsTo(rig, 2)), none({});
  Couplers couplers({&first, &none, &second});
  const Vec3 before = rig.momentum();
  ASSERT_TRUE(advanceWith(&rig, &couplers));
  EXPECT_GT(first.felt().force.norm(), 0);
  EXPECT_EQ(none.felt().force, Vec3::Zero());
  const Vec3 impulse = -rig.time_step * (first.felt().force + second.felt().force);
  EXPECT_LT((rig.momentum() - before - impulse).norm(), 1e-10 * impulse.norm());
}

}  // namespace
}  // namespace incision
