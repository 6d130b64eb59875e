// Clamps that move with a frame.
#include <gtest/gtest.h>

#include <functional>
#include <sstream>

#include "incision/fem/boundary.h"
#include "incision/mesh/grid_mesh.h"
#include "support/failing_solver.h"
#include "support/scenes.h"
#include "support/turning.h"

namespace incision::test {
namespace {

constexpr double EXACT = 1e-12;

Clamp posedLeftEnd() {
  Clamp clamp = clampLeftEnd();
  clamp.frame = "hand";
  return clamp;
}

Scene swungBar() {
  Scene scene = softBar();
  scene.gravity = Vec3(0, 0, -9.81);
  scene.boundary = {posedLeftEnd()};
  return scene;
}

/// By how much the nodes at the left end miss where the frame has them [m].
double miss(const DeformableBody& body, const Pose& first, const Pose& now) {
  double most = 0;
  for (int c = 0; c < body.mesh().numCopies(); ++c) {
    const int node = body.mesh().copyNode(c);
    const Vec3& X = body.mesh().mesh().nodes[node];
    if (X.x() > 1e-6 || body.mesh().ownCopy(node) != c) continue;
    most = std::max(most, (body.positions()[c] - carried(first, now, X)).norm());
  }
  return most;
}

struct Way {
  Method method;
  Integrator integrator;
  bool warping;
};

class PosedClamps : public ::testing::TestWithParam<Way> {
 protected:
  Scene scene() const {
    Scene scene = swungBar();
    scene.solver.method = GetParam().method;
    scene.solver.integrator = GetParam().integrator;
    scene.body.warping = GetParam().warping;
    return scene;
  }
};

TEST_P(PosedClamps, AreAtTheFramesPoseWhenAStepEnds) {
  Scene cut = scene();
  cut.cuts = crossingCuts(0.03);
  DeformableBody body(cut, loadMesh(cut));
  const Pose first = turningFrame(0);
  body.placeClamp(0, first);
  for (int k = 1; k <= 20; ++k) {
    body.moveClamp(0, turningFrame(0.02 * k));
    body.step();
    EXPECT_LT(miss(body, first, turningFrame(0.02 * k)), EXACT) << k;
  }
  EXPECT_GT(body.counts().cracks, 0);
}

// In steps that go evenly the path is the frame's at every step, and only there.
TEST_P(PosedClamps, FollowPosesOfTheSceneFromTheFirstToTheLast) {
  Scene scripted = scene();
  scripted.boundary[0].frame.clear();
  for (const double t : {0.045, 0.1, 0.2}) scripted.boundary[0].poses.push_back({t, turningFrame(t)});
  DeformableBody body(scripted, loadMesh(scripted));
  for (int k = 1; k <= 25; ++k) {
    body.step();
    const double t = std::min(std::max(0.01 * k, 0.045), 0.2);
    const Pose now = t < 0.1 ? between(turningFrame(0.045), turningFrame(0.1), (t - 0.045) / 0.055)
                             : between(turningFrame(0.1), turningFrame(0.2), (t - 0.1) / 0.1);
    EXPECT_LT(miss(body, turningFrame(0.045), now), EXACT) << k;
  }
}

TEST_P(PosedClamps, WithPosesOfAnEvenSpeedMoveAsThoseWithAVelocity) {
  Scene by_poses = scene(), by_velocity = by_poses;
  const Vec3 velocity(0.1, -0.2, 0.3);
  by_poses.boundary[0].frame.clear();
  by_poses.boundary[0].poses = {{0, {Vec3(1, 2, 3), Eigen::Quaterniond(0.6, 0.8, 0, 0)}},
                                {2, {Vec3(1, 2, 3) + 2 * velocity, Eigen::Quaterniond(0.6, 0.8, 0, 0)}}};
  by_velocity.boundary[0] = clampLeftEnd();
  by_velocity.boundary[0].velocity = velocity;
  for (Scene* each : {&by_poses, &by_velocity}) {
    each->cuts = crossingCuts(0.03);
    each->solver.tolerance = 1e-12;
  }
  DeformableBody one(by_poses, loadMesh(by_poses)), other(by_velocity, loadMesh(by_velocity));
  for (int k = 0; k < 30; ++k) {
    one.step();
    other.step();
  }
  EXPECT_LT(largestDifference(one.positions(), other.positions()), GetParam().method == Method::DIRECT ? EXACT : 1e-10);
}

INSTANTIATE_TEST_SUITE_P(
    Ways, PosedClamps,
    ::testing::Values(Way{Method::DIRECT, Integrator::EULER, true}, Way{Method::ITERATIVE, Integrator::EULER, true},
                      Way{Method::DIRECT, Integrator::BDF2, true}, Way{Method::ITERATIVE, Integrator::BDF2, true},
                      Way{Method::DIRECT, Integrator::EULER, false}, Way{Method::DIRECT, Integrator::BDF2, false}));

class HeldByOneFrame : public ::testing::TestWithParam<Way> {};

// Both ends go with one frame, and in the end so does all between them.
TEST_P(HeldByOneFrame, ABodyEndsExactlyTurned) {
  Scene scene = softBar();
  scene.solver.method = GetParam().method;
  scene.solver.integrator = GetParam().integrator;
  scene.solver.tolerance = 1e-12;
  scene.body.material.stiffness_damping = 0.02;
  Clamp right = posedLeftEnd();
  right.place = Place(Vec3(1 - 1e-6, -1, -1), Vec3(2, 1, 1));
  scene.boundary = {posedLeftEnd(), right};
  DeformableBody body(scene, loadMesh(scene));
  for (int k = 0; k <= 1200; ++k) {
    for (int clamp : {0, 1}) body.moveClamp(clamp, turningFrame(std::min(1.0, 0.01 * k)));
    body.step();
  }
  const TetMesh& rest = body.mesh().mesh();
  for (std::size_t n = 0; n < rest.nodes.size(); ++n)
    EXPECT_LT((body.nodePositions()[n] - carried(turningFrame(0), turningFrame(1), rest.nodes[n])).norm(), 1e-9) << n;
  for (const Mat3& stress : body.partStress()) EXPECT_LT(stress.norm(), 1e-9 * 1e5);
  EXPECT_LT(body.motion().kinetic_energy, 1e-15);
}

INSTANTIATE_TEST_SUITE_P(Ways, HeldByOneFrame,
                         ::testing::Values(Way{Method::DIRECT, Integrator::EULER, true},
                                           Way{Method::ITERATIVE, Integrator::EULER, true},
                                           Way{Method::DIRECT, Integrator::BDF2, true}));

// A step taken in halves is two steps of half the length, in which the frame goes half of its way.
TEST(PosedClampsInHalves, GoHalfOfTheWayInEach) {
  Scene whole = swungBar(), half = whole;
  half.solver.time_step /= 2;
  Fallible one(whole);
  DeformableBody other(half, loadMesh(half));
  one.body.placeClamp(0, turningFrame(0));
  other.placeClamp(0, turningFrame(0));
  for (int k = 1; k <= 10; ++k) {
    const Pose from = turningFrame(0.02 * (k - 1)), to = turningFrame(0.02 * k);
    one.body.moveClamp(0, to);
    one.failures.fail({0});
    one.body.step();
    EXPECT_EQ(one.failures.count, 3) << k;
    other.moveClamp(0, between(from, to, 0.5));
    other.step();
    other.moveClamp(0, to);
    other.step();
    EXPECT_LT(miss(one.body, turningFrame(0), to), EXACT) << k;
  }
  EXPECT_LT(largestDifference(one.body.positions(), other.positions()), EXACT);
}

TEST(PosedClamps, StandStillUntilTheSecondPose) {
  Scene scene = swungBar();
  scene.gravity.setZero();
  DeformableBody body(scene, loadMesh(scene));
  run(&body, 3);
  body.moveClamp(0, turningFrame(0.7));
  run(&body, 3);
  EXPECT_EQ(body.motion().max_displacement, 0);
  body.moveClamp(0, turningFrame(0.8));
  body.step();
  EXPECT_LT(miss(body, turningFrame(0.7), turningFrame(0.8)), EXACT);
}

TEST(PosedClamps, PutElsewhereAreThereAtOnceAndAtRest) {
  const Scene scene = swungBar();
  DeformableBody body(scene, loadMesh(scene));
  body.placeClamp(0, turningFrame(0));
  run(&body, 3);
  body.placeClamp(0, turningFrame(0.5));
  EXPECT_LT(miss(body, turningFrame(0), turningFrame(0.5)), EXACT);
  body.step();
  EXPECT_LT(miss(body, turningFrame(0), turningFrame(0.5)), EXACT);
  for (int c = 0; c < body.mesh().numCopies(); ++c)
    if (body.mesh().mesh().nodes[body.mesh().copyNode(c)].x() < 1e-6) {
      EXPECT_LT(body.velocities()[c].norm(), 1e-11);
    }
}

TEST(PosedClamps, BeginAnewAfterAReset) {
  const Scene scene = swungBar();
  DeformableBody body(scene, loadMesh(scene)), twin(scene, loadMesh(scene));
  body.placeClamp(0, turningFrame(0));
  body.moveClamp(0, turningFrame(0.5));
  run(&body, 3);
  body.reset();
  for (DeformableBody* each : {&body, &twin}) {
    run(each, 2);
    each->moveClamp(0, turningFrame(0.6));
    each->step();
    each->moveClamp(0, turningFrame(0.61));
    run(each, 3);
  }
  EXPECT_EQ(body.stateHash(), twin.stateHash());
  EXPECT_LT(miss(body, turningFrame(0.6), turningFrame(0.61)), EXACT);
}

TEST(PosedClamps, OfAStepThatFailsHaveTheirWayStillBeforeThem) {
  const Scene scene = swungBar();
  Fallible failing(scene), twin(scene);
  for (Fallible* each : {&failing, &twin}) {
    each->body.placeClamp(0, turningFrame(0));
    each->body.moveClamp(0, turningFrame(0.02));
    each->body.step();
    each->body.moveClamp(0, turningFrame(0.04));
  }
  failing.failOnce(afterAPart());
  for (Fallible* each : {&failing, &twin}) each->body.step();
  EXPECT_EQ(failing.body.stateHash(), twin.body.stateHash());
}

TEST(PosedClamps, AreSavedWithTheirFirstPoseAndTheirWay) {
  const Scene scene = swungBar();
  DeformableBody one(scene, loadMesh(scene)), other(scene, loadMesh(scene));
  one.placeClamp(0, turningFrame(0));
  run(&one, 2);
  one.moveClamp(0, turningFrame(0.03));
  std::ostringstream bytes;
  one.save(bytes);
  other.restore(bytes.str());
  for (DeformableBody* each : {&one, &other}) {
    each->step();
    each->moveClamp(0, turningFrame(0.05));
    run(each, 2);
  }
  EXPECT_EQ(one.stateHash(), other.stateHash());
}

TEST(PosedClamps, ThatAreNotThereAreRefused) {
  Scene scene = swungBar();
  scene.boundary.push_back({Place(Vec3(1 - 1e-6, -1, -1), Vec3(2, 1, 1)), Vec3::Zero()});  // has no frame
  DeformableBody body(scene, loadMesh(scene));
  for (const int clamp : {-1, 1, 2}) {
    EXPECT_THROW(body.moveClamp(clamp, Pose()), std::out_of_range);
    EXPECT_THROW(body.placeClamp(clamp, Pose()), std::out_of_range);
  }
}

// A loose piece beside clamps is held only between those that move as one.
TEST(PosedClamps, HoldWhatLiesBetweenThoseOfOneFrame) {
  CutMesh mesh(gridMesh({{1, 1, 1}, Vec3::Ones(), Vec3::Zero()}));
  mesh.insert(planeField(plane(Vec3(0, 0.5, 0), Vec3(0, 1, 0.2)), mesh, mesh.mesh().nodes));
  Clamp low = posedLeftEnd(), high = low;
  low.place.box.max = Vec3(1e-6, 2, 0.5);
  high.place.box.min.z() = 0.5;
  high.place.box.max = Vec3(1e-6, 2, 2);
  const auto held = [&](const Clamp& a, const Clamp& b) {
    const std::vector<int> copies = heldCopies(mesh, {a, b}, heldNodes(mesh.mesh(), {a, b}));
    return std::count_if(copies.begin(), copies.end(), [](int clamp) { return clamp >= 0; });
  };
  const auto alike = held(low, high);
  high.frame = "other";
  const auto apart = held(low, high);
  EXPECT_EQ(apart, 4);
  EXPECT_GT(alike, apart);
}

}  // namespace
}  // namespace incision::test
