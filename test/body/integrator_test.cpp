// What a body does with steps of second order.
#include <gtest/gtest.h>

#include "support/contacts.h"
#include "support/scenes.h"

namespace incision::test {
namespace {

Scene withIntegrator(Scene scene, Integrator integrator) {
  scene.solver.integrator = integrator;
  return scene;
}

Scene swingingWithCuts(Integrator integrator) {
  Scene scene = withIntegrator(softBar(), integrator);
  scene.gravity = Vec3(0, 1, -9.81);
  scene.boundary = {clampLeftEnd()};
  scene.cuts = crossingCuts(0.02);
  return scene;
}

std::vector<std::uint64_t> hashesOf(DeformableBody* body, int steps) {
  std::vector<std::uint64_t> hashes;
  for (int k = 0; k < steps; ++k) {
    body->step();
    hashes.push_back(body->stateHash());
  }
  return hashes;
}

TEST(SecondOrder, GivesTheSameStatesForEveryThreadCountAndAfterAReset) {
  std::vector<std::uint64_t> first;
  for (const Method method : {Method::DIRECT, Method::ITERATIVE}) {
    first.clear();
    for (const int threads : {1, 2}) {
      Scene scene = swingingWithCuts(Integrator::BDF2);
      scene.solver.method = method;
      scene.solver.threads = threads;
      DeformableBody body = makeBody(scene);
      for (int run = 0; run < 2; ++run) {
        const std::vector<std::uint64_t> hashes = hashesOf(&body, 20);
        EXPECT_EQ(body.counts().cracks, 3);
        if (first.empty()) first = hashes;
        EXPECT_EQ(hashes, first) << threads << " threads, run " << run;
        body.reset();
      }
    }
  }
}

// Positions at 0.2 s of the bar, which is cut at 0.02, 0.05 and 0.1 s. It moves so little that the cuts go through the
// same elements whatever the step.
std::vector<Vec3> cutBarAfter(Integrator integrator, double time_step) {
  Scene scene = swingingWithCuts(integrator);
  scene.solver.time_step = time_step;
  scene.gravity = Vec3(0, 0, -0.1);
  DeformableBody body = makeBody(scene);
  while (body.time() < 0.2 - time_step / 2) body.step();
  return body.nodePositions();
}

TEST(SecondOrder, IsNearerToTheLimitOfSmallStepsThanEulerAlsoThroughCuts) {
  const std::vector<Vec3> limit = cutBarAfter(Integrator::BDF2, 1.25e-3);
  const double euler = largestDifference(cutBarAfter(Integrator::EULER, 1e-2), limit);
  const double second = largestDifference(cutBarAfter(Integrator::BDF2, 1e-2), limit);
  EXPECT_LT(second, 0.5 * euler);
  // The limit is Euler's too: of a quarter of the step it is about four times nearer.
  EXPECT_NEAR(largestDifference(cutBarAfter(Integrator::EULER, 2.5e-3), limit) / euler, 0.25, 0.1);
}

// Its rotations are those of where the body goes, and tension resists what leads away from there alone.
TEST(SecondOrder, StaysSoUnderTension) {
  const auto after = [](TensionScheme tension, double time_step) {
    Scene scene = withIntegrator(softBar(), Integrator::BDF2);
    scene.gravity = Vec3(9.81, 0, -9.81);
    scene.boundary = {clampLeftEnd()};
    scene.solver.time_step = time_step;
    scene.solver.tension = tension;
    scene.solver.tolerance = 1e-9;
    DeformableBody body = makeBody(scene);
    while (body.time() < 0.2 - time_step / 2) body.step();
    return body.nodePositions();
  };
  const std::vector<Vec3> limit = after(TensionScheme::EXPLICIT, 1.25e-3);
  const double coarse = largestDifference(after(TensionScheme::IMPLICIT, 2e-2), limit);
  const double fine = largestDifference(after(TensionScheme::IMPLICIT, 1e-2), limit);
  EXPECT_LT(fine, 0.35 * coarse);
  EXPECT_LT(fine, 1.5 * largestDifference(after(TensionScheme::EXPLICIT, 1e-2), limit));
}

TEST(SecondOrder, MomentumStaysThroughACutInFlight) {
  Scene scene = withIntegrator(softBar(), Integrator::BDF2);
  scene.gravity = Vec3(0.5, 0, -9.81);
  scene.cuts = crossingCuts(0.02);
  DeformableBody body = makeBody(scene);
  for (int k = 1; k <= 30; ++k) {
    body.step();
    const Vec3 expected = body.motion().mass * scene.gravity * body.time();
    EXPECT_LT((body.motion().momentum - expected).norm(), 1e-11 * expected.norm()) << "step " << k;
  }
  EXPECT_EQ(body.counts().cracks, 3);
}

TEST(SecondOrder, IsEulerWhileTheBodyIsTouched) {
  const Scene scene = blockAbove(0, {2, 2, 2}, Vec3::Zero());
  DeformableBody euler = makeBody(withIntegrator(scene, Integrator::EULER));
  DeformableBody second = makeBody(withIntegrator(scene, Integrator::BDF2));
  EXPECT_EQ(hashesOf(&euler, 20), hashesOf(&second, 20));
}

TEST(SecondOrder, ABlockThatFallsDoesNotReboundFromThePast) {
  const Scene scene = withIntegrator(blockAbove(0, {2, 2, 2}, Vec3(0, 0, 0.3)), Integrator::BDF2);
  DeformableBody body = makeBody(scene);
  const double height = 0.3, start = height * body.motion().mass * 9.81;
  const auto energy = [&] {
    const BodyMotion motion = body.motion();
    return motion.kinetic_energy + motion.elastic_energy + motion.mass * 9.81 * (centreOfMass(body).z() - ELEMENT);
  };
  double highest = 0;
  bool touched = false;
  for (int k = 0; k < 200; ++k) {
    touched = body.step().contact.count > 0 || touched;
    highest = std::max(highest, energy());
  }
  EXPECT_TRUE(touched);
  EXPECT_LT(highest, start * (1 + 1e-3));  // the formula's own error in free fall: g Δt² of the height, at most
  EXPECT_LT(std::abs(centreOfMass(body).z() - ELEMENT), 0.05 * ELEMENT);
}

}  // namespace
}  // namespace incision::test
