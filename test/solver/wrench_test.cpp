#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <random>

#include "incision/solver/coupling.h"
#include "support/rig.h"

namespace incision {
namespace {

RigSettings settings() {
  RigSettings settings;
  settings.material = {1e5, 0.3, 1000, 0, 1e-3};
  return settings;
}

/// Springs between the tool and any points of the body, about as stiff as an element is.
std::vector<Coupling> springsTo(const Rig& rig, unsigned seed) {
  std::mt19937 generator(seed);
  std::uniform_int_distribution<int> anyCopy(0, rig.mesh.numCopies() - 1);
  std::vector<Coupling> springs;
  for (const Vec3& force : randomVectors(10, 100, seed)) {
    Coupling spring;
    for (const double weight : {0.1, 0.2, 0.3, 0.4}) spring.add(anyCopy(generator), weight);
    spring.stiffness = 1e4 * (Mat3::Identity() + 1e-4 * force * force.transpose());
    spring.force = force;
    spring.tool = true;
    springs.push_back(spring);
  }
  return springs;
}

TEST(Wrench, IsAgainstTheImpulsesAndTheirMoment) {
  Rig rig(block({2, 2, 2}, Vec3::Ones()), settings());
  std::vector<Coupling> springs = springsTo(rig, 1);
  const std::vector<Vec3> v_end = randomVectors(rig.motion.x.size(), 1, 2);
  std::vector<Vec3> impulses(rig.motion.x.size(), Vec3::Zero());
  addImpulses(springs, rig.time_step, v_end, &impulses);
  Wrench sum;
  for (std::size_t c = 0; c < impulses.size(); ++c) {
    sum.force -= impulses[c] / rig.time_step;
    sum.torque -= rig.motion.x[c].cross(impulses[c]) / rig.time_step;
  }
  const Wrench wrench = toolWrench(springs, rig.time_step, rig.motion.x, v_end);
  EXPECT_LT((wrench.force - sum.force).norm(), 1e-12 * sum.force.norm());
  EXPECT_LT((wrench.torque - sum.torque).norm(), 1e-12 * sum.torque.norm());
  for (Coupling& spring : springs) spring.tool = false;
  EXPECT_EQ(toolWrench(springs, rig.time_step, rig.motion.x, v_end).force, Vec3::Zero());
}

// Couplings that are never content: the step ends somewhere between two solves.
TEST(Wrench, TakesTheMomentumThatTheBodyGainsWhereverTheStepEnds) {
  for (const bool alternate : {false, true}) {
    Rig rig(block({2, 2, 2}, Vec3::Ones()), settings());
    const std::vector<Coupling> springs[2] = {springsTo(rig, 1), springsTo(rig, 2)};
    for (int n = 0; n < 5; ++n) {
      const Vec3 before = rig.momentum();
      int calls = 0;
      ASSERT_TRUE(rig.step.advance(0, rig.time_step, &rig.motion,
                                   [&](double, const std::vector<Vec3>&, std::vector<Coupling>* couplings) {
                                     *couplings = springs[calls % 2];
                                     ++calls;
                                     return alternate;
                                   }));
      EXPECT_EQ(calls > 3, alternate);
      const Vec3 given = -rig.time_step * rig.step.onTool().force;
      EXPECT_LT((rig.momentum() - before - given).norm(), 1e-10 * given.norm()) << alternate;
    }
  }
}

TEST(Wrench, IsNoneInAStepWithoutCouplings) {
  Rig rig(block({2, 2, 2}, Vec3::Ones()), settings());
  ASSERT_TRUE(rig.step.advance(0, rig.time_step, &rig.motion,
                               [&](double, const std::vector<Vec3>&, std::vector<Coupling>* couplings) {
                                 *couplings = springsTo(rig, 1);
                                 return false;
                               }));
  EXPECT_GT(rig.step.onTool().force.norm(), 0);
  ASSERT_TRUE(rig.advance());
  EXPECT_EQ(rig.step.onTool().force, Vec3::Zero());
}

}  // namespace
}  // namespace incision
