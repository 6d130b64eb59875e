#include <gtest/gtest.h>

#include "incision/solver/implicit_step.h"
#include "support/deformed_mesh.h"

namespace incision {
namespace {

// Starts from which elements have no volume or a negative one.
class CollapsedStart : public ::testing::TestWithParam<Vec3> {};

TEST_P(CollapsedStart, StepsStayFiniteAndKeepTheMomentum) {
  const GridSettings box = {{2, 2, 2}, Vec3::Ones(), Vec3::Zero()};
  for (Method method : {Method::DIRECT, Method::ITERATIVE})
    for (bool warping : {true, false}) {
      test::Random random(70);
      test::DeformedMesh body(test::jitteredGrid(box, 0.2, &random));
      for (int k = 0; k < 4; ++k) body.cut(random.plane(box));
      SolverSettings settings;
      settings.method = method;
      settings.threads = 1;
      const Material tissue = {1e4, 0.4, 1000, 0, 1e-3};
      BoundaryConditions conditions;
      conditions.gravity = Vec3(0, 0, -9.81);
      const Materials materials(body.mesh.mesh(), tissue);
      ImplicitStep step(body.mesh, materials, Mass::LUMPED, Pressure::ELEMENT, warping, conditions, settings);
      Motion motion = {body.x, std::vector<Vec3>(body.x.size(), Vec3::Zero())};
      for (Vec3& x : motion.x) x = x.cwiseProduct(GetParam());
      step.topologyChanged(motion);
      const int steps = 10;
      for (int k = 0; k < steps; ++k) {
        step.begin(0.01, motion);
        ASSERT_TRUE(step.advance(k * 0.01, &motion)) << "step " << k;
      }
      Vec3 momentum = Vec3::Zero();
      double largest = 0;
      for (std::size_t c = 0; c < motion.x.size(); ++c) {
        ASSERT_TRUE(motion.x[c].allFinite() && motion.v[c].allFinite());
        momentum += step.assembly().masses()[c] * motion.v[c];
        largest = std::max(largest, motion.v[c].norm());
      }
      // Inner forces cancel, to the solver's tolerance of what moves at the most.
      const double tolerance = method == Method::DIRECT ? 1e-9 : 1e-4;
      EXPECT_LT((momentum - 1000 * 0.1 * conditions.gravity).norm(), tolerance * 1000 * std::max(largest, 1.0));
    }
}

INSTANTIATE_TEST_SUITE_P(Scales, CollapsedStart,
                         ::testing::Values(Vec3(0, 0, 0), Vec3(1, 1, 0), Vec3(1, 0, 0), Vec3(-1, 1, 1),
                                           Vec3(-1, -1, -1), Vec3(1, 1, -1e-12), Vec3(-3, 0.1, 0.1)));

}  // namespace
}  // namespace incision
