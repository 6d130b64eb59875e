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
  const std::vector<Vec3> v_end = randomVectors(rig.motion.x.size(), 1, 2);
  std::vector<Vec3> impulses(rig.motion.x.size(), Vec3::Zero());
  addImpulses(springs, rig.time_step, v_end, &impulses);
  Wrench sum;
  for (std::size_t c = 0; c < impulses.size(); ++c) {
    sum.force -= impulses[c] / rig.time_step;
    sum.torque -= rig.motion.x[c].cross(impulses[c]) / rig.time_step;
  }
  Wrench wrench;
  for (const Spring& spring : springs) {
    const Wrench one = wrenchOf(spring, rig.time_step, rig.motion.x, v_end);
    wrench.force += one.force;
    wrench.torque += one.torque;
  }
  EXPECT_LT((wrench.force - sum.force).norm(), 1e-12 * sum.force.norm());
  EXPECT_LT((wrench.torque - sum.torque).norm(), 1e-12 * sum.torque.norm());
}

// Springs that are never content: the step ends somewhere between two solves.
TEST(Wrench, TakesTheMomentumThatTheBodyGainsWhereverTheStepEnds) {
  for (const bool alternate : {false, true}) {
    Rig rig(block({2, 2, 2}, Vec3::Ones()), settings());
    const std::vector<Spring> springs[2] = {springsTo(rig, 1), springsTo(rig, 2)};
    for (int n = 0; n < 5; ++n) {
      const Vec3 before = rig.momentum();
      int calls = 0;
      GivenSprings given([&](const std::vector<Vec3>&, std::vector<Spring>* list) {
        *list = springs[calls % 2];
        ++calls;
        return alternate;
      });
      Couplers couplers({&given});
      ASSERT_TRUE(advanceWith(&rig, &couplers));
      EXPECT_EQ(calls > 3, alternate);
      const Vec3 impulse = -rig.time_step * given.felt().force;
      EXPECT_LT((rig.momentum() - before - impulse).norm(), 1e-10 * impulse.norm()) << alternate;
    }
  }
}

TEST(Wrench, GoesToTheCouplerWhoseSpringsGiveIt) {
  Rig rig(block({2, 2, 2}, Vec3::Ones()), settings());
  const auto giving = [&](unsigned seed) {
    return GivenSprings([&rig, seed](const std::vector<Vec3>&, std::vector<Spring>* list) {
      for (const Spring& spring : springsTo(rig, seed)) list->push_back(spring);
      return false;
    });
  };
  GivenSprings first = giving(1), second = giving(2), none([](const auto&, auto*) { return false; });
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
