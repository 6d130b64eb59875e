// Guards against hitches that a quiet machine does not show: what a step takes from the heap, on two threads.
#include <gtest/gtest.h>

#include <memory>
#include <thread>

#include "support/allocation_hooks.h"
#include "support/forceps.h"
#include "support/sanitized.h"
#include "support/scenes.h"
#include "support/tool.h"

namespace incision::test {
namespace {

// The first steps start the threads and let every vector grow to its size; then the step counts.
constexpr int FIRST_STEPS = 5, WATCHED_STEPS = 20;

const std::array<int, 3> SMALL = {16, 4, 4}, LARGE = {32, 8, 8};

Scene barWith(Method method, const std::array<int, 3>& cells) {
  Scene scene = swingingBar(cells, 1e6);
  scene.solver.method = method;
  return scene;
}

std::int64_t allocationsOfUncutSteps(const Scene& scene) {
  DeformableBody body(scene, loadMesh(scene));
  run(&body, FIRST_STEPS);
  return allocationsOf([&] { run(&body, WATCHED_STEPS); });
}

std::int64_t allocationsOfCut(const Scene& scene) {
  DeformableBody body(scene, loadMesh(scene));
  run(&body, FIRST_STEPS);
  return allocationsOf([&] {
    EXPECT_EQ(body.cut(slantedCut()).status, CutStatus::APPLIED);
    body.step();
  });
}

class StepAllocations : public ::testing::Test {
 protected:
  void SetUp() override {
    if (SANITIZED) GTEST_SKIP() << "nothing is counted under the sanitizers";
  }
};

TEST_F(StepAllocations, AreCountedOnEveryThread) {
  std::vector<std::unique_ptr<int>> made(10);
  const auto make = [&] {
    for (auto& value : made) value = std::make_unique<int>(1);
  };
  EXPECT_EQ(allocationsOf(make), 10);
  EXPECT_GE(allocationsOf([&] { std::thread(make).join(); }), 10);
}

TEST_F(StepAllocations, AreNoneWithoutACut) {
  for (const Method method : {Method::AUTO, Method::ITERATIVE})
    for (const auto& cells : {SMALL, LARGE}) EXPECT_EQ(allocationsOfUncutSteps(barWith(method, cells)), 0);
  Scene second_order = barWith(Method::AUTO, SMALL);
  second_order.solver.integrator = Integrator::BDF2;
  EXPECT_EQ(allocationsOfUncutSteps(second_order), 0);
  Scene averaged = barWith(Method::ITERATIVE, SMALL);
  averaged.body.pressure = Pressure::AVERAGED;
  EXPECT_EQ(allocationsOfUncutSteps(averaged), 0);
  Scene posed = barWith(Method::ITERATIVE, SMALL);
  posed.boundary[0].poses = {{0, Pose()}, {1, {Vec3(0, 0, 0.1), Eigen::Quaterniond(0.8, 0.6, 0, 0)}}};
  Load pressure;
  pressure.place = Place(Vec3(1 - 1e-6, -1, -1), Vec3(2, 1, 1));
  pressure.pressure = 100;
  posed.loads = {pressure};
  EXPECT_EQ(allocationsOfUncutSteps(posed), 0);
  Scene with_tool = barWith(Method::ITERATIVE, SMALL);
  with_tool.tools = {bladeTool(Edge{Vec3(0, 0, -0.1), Vec3(0, 0, 0.1)})};
  with_tool.tools[0].poses = {{0, {Vec3(0, 0, 50), Eigen::Quaterniond::Identity()}}};
  EXPECT_EQ(allocationsOfUncutSteps(with_tool), 0);
}

// Held still, and pulled so that it slips.
TEST_F(StepAllocations, AreNoneWhileAGrasperHolds) {
  for (const double speed : {0.0, 0.05}) {
    Scene scene = slabAndForceps(0.05, false);
    scene.solver.method = Method::ITERATIVE;
    scene.gravity.setZero();
    scene.boundary = {SLAB_END};
    scene.tools[0].poses = {{0, AT_EDGE}, {1, facingX(AT_EDGE.position.x() - speed)}};
    scene.tools[0].jaw->angles = {{0, FORCEPS_OPEN}, {0.01, 0.03}};
    DeformableBody body(scene, loadMesh(scene), {{forcepsUrdf({})}, ""});
    run(&body, 8 * FIRST_STEPS);
    double least = 1, most = 0;
    const auto steps = [&] {
      for (int k = 0; k < WATCHED_STEPS; ++k) {
        const ToolReport report = body.step().tools[0];
        least = std::min(least, report.force.norm() / report.gripped);
        most = std::max(most, report.force.norm() / report.gripped);
      }
    };
    EXPECT_EQ(allocationsOf(steps), 0) << speed;
    EXPECT_TRUE(speed > 0 ? least > 0.9 : most < 1e-6) << least << " " << most;
  }
}

TEST_F(StepAllocations, KeepTheirBoundInTheStepOfACut) {
  EXPECT_LE(allocationsOfCut(barWith(Method::ITERATIVE, SMALL)), 12000);  // counted: 10618
  EXPECT_LE(allocationsOfCut(barWith(Method::ITERATIVE, LARGE)), 43800);  // counted: 38952
}

}  // namespace
}  // namespace incision::test
