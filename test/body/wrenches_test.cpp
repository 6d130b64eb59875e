// What a body does to clamps and obstacles, against what its momentum tells.
#include <gtest/gtest.h>

#include "support/contacts.h"
#include "support/failing_solver.h"
#include "support/turning.h"

namespace incision::test {
namespace {

constexpr double BALANCED = 1e-10;

Scene swingingSoftBar() {
  Scene scene = softBar();
  scene.gravity = Vec3(0, 1, -9.81);
  scene.body.material.stiffness_damping = 1e-3;
  scene.boundary = {clampLeftEnd()};
  return scene;
}

Vec3 allForcesOn(const BodyWrenches& wrenches) {
  Vec3 sum = wrenches.ground.force;
  for (const Wrench& wrench : wrenches.clamps) sum += wrench.force;
  for (const Wrench& wrench : wrenches.obstacles) sum += wrench.force;
  return sum;
}

/// Takes a step, and compares the forces with the change of momentum. Returns the largest of them [N].
double expectBalance(DeformableBody* body, const Vec3& loads = Vec3::Zero()) {
  const BodyMotion before = body->motion();
  body->step();
  const Vec3 weight = before.mass * body->scene().gravity;
  const Vec3 rate = (body->motion().momentum - before.momentum) / body->scene().solver.time_step;
  const Vec3 outside = weight + loads - allForcesOn(body->wrenches());
  double largest = weight.norm();
  for (const Wrench& wrench : body->wrenches().clamps) largest = std::max(largest, wrench.force.norm());
  EXPECT_LT((rate - outside).norm(), BALANCED * largest) << body->steps();
  return largest;
}

TEST(Wrenches, OfAClampTellWhatASwingingBarsMomentumTells) {
  for (const Mass mass : {Mass::LUMPED, Mass::CONSISTENT}) {
    for (const bool warping : {true, false}) {
      Scene scene = swingingSoftBar();
      scene.body.mass = mass;
      scene.body.warping = warping;
      DeformableBody body(scene, loadMesh(scene));
      body.wantWrenches(true);
      for (int k = 0; k < 40; ++k) expectBalance(&body);
      EXPECT_GT(std::abs(body.motion().momentum.z()), 1);
    }
  }
}

TEST(Wrenches, BalanceOverACutToo) {
  Scene scene = swingingSoftBar();
  scene.cuts = crossingCuts(0.1);
  DeformableBody body(scene, loadMesh(scene));
  body.wantWrenches(true);
  for (int k = 0; k < 40; ++k) expectBalance(&body);
  EXPECT_GT(body.counts().pieces, 2);
}

TEST(Wrenches, OfSeveralMovingClampsUnderLoadsBalance) {
  Scene scene = swingingSoftBar();
  Clamp right;
  right.place = Place(Vec3(1 - 1e-6, -1, -1), Vec3(2, 1, 1));
  right.frame = "hand";
  scene.boundary.push_back(right);
  Load load;
  load.place = Place(Vec3(-1, -1, 0.25 - 1e-6), Vec3(2, 1, 1));  // the top, with nodes of the clamps
  load.traction = Vec3(100, 200, -300);
  scene.loads = {load};
  DeformableBody body(scene, loadMesh(scene));
  body.wantWrenches(true);
  body.placeClamp(1, turningFrame(0));
  for (int k = 1; k <= 30; ++k) {
    body.moveClamp(1, turningFrame(0.01 * k));
    expectBalance(&body, 0.25 * load.traction);
  }
}

// A block on a ground and beside a box that moves into it, its top held by a clamp that does not.
TEST(Wrenches, OfClampGroundAndObstaclesBalance) {
  Scene scene = blockAbove(0, {6, 3, 3}, Vec3(0, 0, 0.0005));
  Clamp top;
  top.place = Place(Vec3(0.14, -1, 0.15), Vec3(0.16, 1, 1));
  scene.boundary = {top};
  scene.cuts = {{0.05, plane(Vec3(0.21, 0, 0), Vec3(1, 0.2, 0.3))}};
  DeformableBody body = bodyAmong(scene, urdfOf("<box size='0.1 1 1'/>", "-0.06 0 0.5"));
  body.wantWrenches(true);
  double ground = 0, box = 0;
  for (int k = 0; k < 60; ++k) {
    Pose pose;
    pose.position.x() = 0.0005 * k;
    body.moveObstacle(0, pose);
    expectBalance(&body);
    ground = std::min(ground, body.wrenches().ground.force.z());
    box = std::min(box, body.wrenches().obstacles[0].force.x());
  }
  EXPECT_EQ(body.counts().pieces, 2);
  EXPECT_LT(ground, -1);
  EXPECT_LT(box, -1);
}

TEST(Wrenches, OfAStepInHalvesAreTheMeanOverIt) {
  Scene scene = swingingSoftBar();
  Fallible one(scene);
  one.body.wantWrenches(true);
  for (int k = 0; k < 10; ++k) {
    one.failures.fail({0});
    expectBalance(&one.body);
    EXPECT_EQ(one.failures.count, 3);
  }
}

// At rest the forces bear the weight, and the torques that of the weight about the body's origin.
TEST(Wrenches, AtRestBearTheWeight) {
  Scene scene = blockAbove(0, {6, 2, 2}, Vec3::Zero());
  scene.body.material.mass_damping = 5;
  scene.boundary = {{Place(Vec3(-1, -1, -1), Vec3(1e-6, 1, 1)), Vec3::Zero()}};
  scene.contact->friction = 0;
  DeformableBody body(scene, loadMesh(scene));
  body.wantWrenches(true);
  run(&body, 400);
  const Vec3 weight = body.motion().mass * scene.gravity;
  const Wrench &clamp = body.wrenches().clamps[0], &ground = body.wrenches().ground;
  EXPECT_LT((clamp.force + ground.force - weight).norm(), 1e-6 * weight.norm());
  EXPECT_LT((clamp.torque + ground.torque - centreOfMass(body).cross(weight)).norm(), 1e-4 * weight.norm() * 0.3);
  EXPECT_LT(clamp.force.z(), 0);
  EXPECT_LT(ground.force.z(), 0.3 * weight.z());
}

// A box that stands under the block, its link off the block's middle and turned.
TEST(Wrenches, OfAnObstacleAreAboutItsLinksOrigin) {
  Scene scene = blockAbove(-1, {4, 2, 2}, Vec3::Zero());
  scene.body.material.mass_damping = 5;
  DeformableBody body = bodyAmong(scene, urdfOf("<box size='2 2 0.2'/>"));
  const Pose link = {Vec3(0.3, 0.2, -0.1), Eigen::Quaterniond(0.8, 0, 0, 0.6)};
  body.placeObstacle(0, link);
  body.wantWrenches(true);
  run(&body, 400);
  const Vec3 weight = body.motion().mass * scene.gravity, lever = centreOfMass(body) - link.position;
  const Wrench& wrench = body.wrenches().obstacles[0];
  EXPECT_LT((wrench.force - weight).norm(), 1e-6 * weight.norm());
  EXPECT_LT((wrench.torque - lever.cross(weight)).norm(), 1e-4 * lever.cross(weight).norm());
  EXPECT_EQ(body.wrenches().ground.force, Vec3::Zero());
}

TEST(Wrenches, OfAClampAreAboutTheOriginOfItsFrame) {
  Scene fixed = swingingSoftBar(), posed = fixed;
  posed.boundary[0].frame = "hand";
  DeformableBody one(fixed, loadMesh(fixed)), other(posed, loadMesh(posed));
  const Pose frame = turningFrame(0.3);
  other.placeClamp(0, frame);
  for (DeformableBody* each : {&one, &other}) {
    each->wantWrenches(true);
    run(each, 5);
  }
  const Wrench &about_body = one.wrenches().clamps[0], &about_frame = other.wrenches().clamps[0];
  EXPECT_GT(about_body.force.norm(), 1);
  EXPECT_LT((about_frame.force - about_body.force).norm(), BALANCED * about_body.force.norm());
  EXPECT_LT((about_frame.torque + frame.position.cross(about_body.force) - about_body.torque).norm(),
            BALANCED * about_body.torque.norm());
}

TEST(Wrenches, AreFoundOnlyWhereTheyAreWantedAndChangeNothing) {
  Scene scene = blockAbove(0, {4, 2, 2}, Vec3(0, 0, 0.001));
  scene.boundary = {{Place(Vec3(-1, -1, -1), Vec3(1e-6, 1, 1)), Vec3::Zero()}};
  DeformableBody asked(scene, loadMesh(scene)), unasked(scene, loadMesh(scene));
  asked.wantWrenches(true);
  ASSERT_EQ(asked.wrenches().clamps.size(), 1u);
  EXPECT_EQ(asked.wrenches().clamps[0].force, Vec3::Zero());
  run(&asked, 10);
  run(&unasked, 10);
  EXPECT_EQ(asked.stateHash(), unasked.stateHash());
  EXPECT_NE(asked.wrenches().clamps[0].force, Vec3::Zero());
  EXPECT_TRUE(unasked.wrenches().clamps.empty());
  asked.reset();
  EXPECT_EQ(asked.wrenches().clamps[0].force, Vec3::Zero());
}

TEST(ContactPoints, TellWhereTheGroundBearsTheBody) {
  Scene scene = blockAbove(0, {3, 3, 3}, Vec3::Zero());
  scene.contact->friction = 0;
  DeformableBody body(scene, loadMesh(scene));
  body.wantWrenches(true);
  run(&body, 200);
  const BodyWrenches& wrenches = body.wrenches();
  EXPECT_EQ(wrenches.points.size(), 16u);
  Vec3 sum = Vec3::Zero();
  double deepest = 0;
  for (const ContactPoint& point : wrenches.points) {
    EXPECT_EQ(point.normal, Vec3::UnitZ());
    EXPECT_GT(point.force.z(), 0);
    EXPECT_NEAR(point.point.z(), -point.depth, 1e-12);
    EXPECT_GE(point.partner, 0);
    EXPECT_EQ(point.tool, -1);
    sum += point.force;
    deepest = std::max(deepest, point.depth);
  }
  EXPECT_LT((sum + wrenches.ground.force).norm(), BALANCED * sum.norm());
  EXPECT_GT(deepest, 0);
}

TEST(ContactPoints, LieOnThePieceThatIsPressed) {
  Scene scene = blockAbove(0, {2, 2, 4}, Vec3::Zero());
  scene.cuts = {{0, plane(Vec3(0.05, 0.05, 0.11), Vec3::UnitZ())}};
  DeformableBody body(scene, loadMesh(scene));
  body.wantWrenches(true);
  run(&body, 300);
  double upwards = 0;
  for (const ContactPoint& point : body.wrenches().points) {
    if (point.partner >= 0) continue;
    EXPECT_NEAR(point.point.z(), 0.11, 0.02);
    upwards += std::abs(point.force.z());
  }
  // The weight of the upper piece: each point is pressed by what it lies on or by what lies on it.
  EXPECT_NEAR(upwards, 0.1 * 0.1 * 0.09 * 1000 * 9.81, 0.01 * 0.883 * 9.81);
}

}  // namespace
}  // namespace incision::test
