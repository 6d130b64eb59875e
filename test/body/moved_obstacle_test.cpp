#include <gtest/gtest.h>

#include "incision/body/deformable_body.h"
#include "incision/mesh/grid_mesh.h"

namespace incision {
namespace {

constexpr double RADIUS = 0.1;  // of the ball [m]

const std::string BALL =
    "<robot name=\"r\"><link name=\"ball\"><collision><geometry><sphere radius=\"0.1\"/></geometry></collision></link>"
    "</robot>";

Pose at(double y) {
  Pose pose;
  pose.position = Vec3(0.9, y, 0.1);
  return pose;
}

/// A bar along x from y = 0 to 0.2, held at its left end, and a ball that stands clear of its tip.
struct MovedObstacleTest : testing::Test {
  MovedObstacleTest() : body(scene(), gridMesh({{8, 2, 2}, Vec3(1, 0.2, 0.2), Vec3::Zero()}), {{}, BALL}) {
    body.placeObstacle(0, at(-0.2));
    body.step();
  }
  static Scene scene() {
    Scene scene;
    scene.gravity.setZero();
    scene.boundary.push_back({{Vec3(-1, -1, -1), Vec3(1e-6, 1, 1)}, Vec3::Zero()});
    scene.contact.emplace();
    scene.contact->obstacles = "ball.urdf";
    return scene;
  }
  double displacement() const { return body.motion().max_displacement; }

  DeformableBody body;
};

TEST_F(MovedObstacleTest, PushesTheBodyAheadOfIt) {
  for (int k = 1; k <= 40; ++k) {
    body.moveObstacle(0, at(-0.2 + 0.005 * k));  // at 0.5 m/s
    body.step();
  }
  double lowest = 1;
  for (const Vec3& x : body.positions())
    if (x.x() > 0.8) lowest = std::min(lowest, x.y());
  // The ball's foremost point is at y = 0.1; a node of the bar's tip is at most half a cell's 0.125 m beside it in x.
  EXPECT_GT(lowest, 0.02);
  EXPECT_LT(displacement(), 0.2);
}

TEST_F(MovedObstacleTest, PutAcrossTheBodySweepsNothing) {
  body.placeObstacle(0, at(0.2 + 2 * RADIUS));
  for (int k = 0; k < 10; ++k) body.step();
  EXPECT_EQ(displacement(), 0);
}

TEST_F(MovedObstacleTest, MovedAcrossTheBodyInOneStepTakesItAlong) {
  body.moveObstacle(0, at(0.2 + 2 * RADIUS));
  body.step();
  EXPECT_GT(displacement(), 0.1);
}

}  // namespace
}  // namespace incision
