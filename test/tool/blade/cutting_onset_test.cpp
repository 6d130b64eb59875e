#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <vector>

#include "incision/mesh/grid_mesh.h"
#include "support/pushed_blade.h"
#include "support/sanitized.h"

namespace incision {
namespace {

constexpr double FORCE = 100;                                                            // [N/m]
constexpr double ONSET = 900;                                                            // [N/m]
constexpr double SPEED = 0.05;                                                           // [m/s]
constexpr double STRIDE = 5e-4;                                                          // in a step at this speed [m]
constexpr double STEADY = FORCE * BLOCK_HEIGHT, FIRST = (FORCE + ONSET) * BLOCK_HEIGHT;  // [N]

Scene toughSkin(double onset = ONSET, int cells = 3) {
  Scene scene = blockAndEdge(cells, FORCE);
  scene.body.material.young_modulus = 3e5;
  bladeOf(&scene.tools[0]).cutting.resistance.onset = onset;
  return scene;
}

/// Pushes step by step until the force has fallen to half of what it was, or to an end. Returns where that was.
double pushUntilItEnters(Pushed* pushed, double end) {
  double before = 0;
  while (pushed->x < end) {
    pushed->to(pushed->x + STRIDE, SPEED);
    const double force = -pushed->report.force.x();
    if (force < 0.5 * before) break;
    before = std::max(before, force);
  }
  return pushed->x;
}

TEST(CuttingOnset, UntilItIsReachedTheBodyIsIndentedUncut) {
  Pushed pushed(toughSkin(1e9));
  const BodyCounts counts = pushed.body.counts();
  double before = 0;
  for (const double x : {0.002, 0.004, 0.008, 0.012}) {
    pushed.to(x, SPEED);
    EXPECT_GT(-pushed.report.force.x(), before) << x;
    before = -pushed.report.force.x();
    EXPECT_TRUE(pushed.report.touching) << x;
  }
  EXPECT_EQ(pushed.report.stroke_area, 0);
  EXPECT_EQ(pushed.body.counts().parts, counts.parts);
  EXPECT_EQ(pushed.body.counts().copies, counts.copies);
  EXPECT_EQ(pushed.body.counts().cracks, 0);
}

TEST(CuttingOnset, AnEdgeThatIsWithdrawnBeforeLeavesNoTrace) {
  Pushed pushed(toughSkin(1e9));
  const BodyCounts counts = pushed.body.counts();
  pushed.to(0.008, SPEED);
  pushed.to(-0.02, SPEED);
  EXPECT_TRUE(pushed.body.takeReports().cuts.empty());
  EXPECT_EQ(pushed.body.counts().copies, counts.copies);
  EXPECT_FALSE(pushed.report.touching);
  EXPECT_EQ(pushed.report.force, Vec3::Zero());
}

TEST(CuttingOnset, IsReachedAtTheDepthAtWhichTheForceOnTheUncutBodyReachesIt) {
  for (const int cells : test::SANITIZED ? std::vector<int>{3} : std::vector<int>{3, 5}) {
    Pushed uncut(toughSkin(1e9, cells)), pushed(toughSkin(ONSET, cells));
    const double entered = pushUntilItEnters(&pushed, 0.06);
    EXPECT_NEAR(pushed.most, FIRST, 0.1 * FIRST) << cells;
    while (-uncut.report.force.x() < FIRST) uncut.to(uncut.x + STRIDE, SPEED);
    EXPECT_NEAR(entered, uncut.x, 0.1 * uncut.x + 2 * STRIDE) << cells;
    EXPECT_GT(uncut.x, 8 * STRIDE) << cells;
  }
}

TEST(CuttingOnset, OnceTheEdgeHasEnteredItAdvancesAgainstTheCuttingForce) {
  Pushed pushed(toughSkin());
  pushUntilItEnters(&pushed, 0.06);
  pushed.to(pushed.x + 0.02, SPEED);
  for (const double x : {0.07, 0.09, 0.11}) {
    pushed.to(x, SPEED);
    EXPECT_NEAR(-pushed.report.force.x(), STEADY, 0.05 * STEADY) << x;
    EXPECT_NEAR(pushed.report.stroke_area, BLOCK_HEIGHT * x, 0.05 * BLOCK_HEIGHT * x) << x;
  }
}

TEST(CuttingOnset, AsLongAsTheEdgeStaysInItsCutItNeedsNoOther) {
  Pushed pushed(toughSkin());
  pushUntilItEnters(&pushed, 0.06);
  pushed.to(0.08, SPEED);
  pushed.to(0.05, SPEED);
  pushed.most = 0;
  pushed.to(0.11, SPEED);
  EXPECT_LT(pushed.most, 1.1 * STEADY);
}

TEST(CuttingOnset, AfterTheEdgeHasLeftTheBodyItIsNeededAgain) {
  Pushed pushed(toughSkin());
  pushUntilItEnters(&pushed, 0.06);
  pushed.to(-0.02, SPEED);
  pushed.body.liftTool();
  for (int k = 0; k < 200; ++k) pushed.body.step();
  pushed.body.placeTool(poseAt(-0.02, PUSHED_AT + 0.03));
  double most = 0;
  for (double x = -0.02; x < 0.05; x += STRIDE) {
    pushed.body.guideTool({poseAt(x, PUSHED_AT + 0.03)});
    most = std::max(most, -pushed.body.step().tools[0].force.x());
  }
  EXPECT_GT(most, 0.8 * FIRST);
}

/// Two blocks on top of each other along the edge, which comes to the upper one 0.04 m later.
TEST(CuttingOnset, WhatDoesNotHangTogetherBeforeTheEdgeIsEnteredEachForItself) {
  Scene scene = toughSkin();
  scene.body.grid.reset();
  TetMesh mesh = gridMesh({{10, 5, 2}, Vec3(0.2, 0.1, 0.04), Vec3(0, -0.05, 0)});
  const TetMesh upper = gridMesh({{10, 5, 2}, Vec3(0.2, 0.1, 0.04), Vec3(0.04, -0.05, 0.06)});
  const int first = static_cast<int>(mesh.nodes.size());
  mesh.nodes.insert(mesh.nodes.end(), upper.nodes.begin(), upper.nodes.end());
  for (std::array<int, 4> element : upper.elements) {
    for (int& n : element) n += first;
    mesh.elements.push_back(element);
  }
  scene.boundary[0].place = Place(Vec3(0.2 - 1e-6, -1, -1), Vec3(1, 1, 1));
  DeformableBody body(scene, mesh);
  const double first_one = (FORCE + ONSET) * 0.04, steady = FORCE * 0.04;
  body.placeTool(poseAt(-0.01, PUSHED_AT));
  double most[2] = {0, 0};
  for (double x = -0.01; x < 0.09; x += STRIDE) {
    body.guideTool({poseAt(x, PUSHED_AT)});
    double& most_then = most[x > 0.04 ? 1 : 0];
    most_then = std::max(most_then, -body.step().tools[0].force.x());
  }
  EXPECT_NEAR(most[0], first_one, 0.1 * first_one);
  EXPECT_NEAR(most[1], first_one + steady, 0.1 * first_one);
}

TEST(CuttingOnset, ARegionMayTakeAnother) {
  Scene scene = toughSkin(0);
  RegionSettings skin;
  skin.place = {Vec3(-1, -1, -1), Vec3(0.034, 1, 1)};
  skin.cutting_onset = ONSET;
  scene.body.regions = {skin};
  Pushed pushed(scene), twin(toughSkin());
  EXPECT_EQ(pushUntilItEnters(&pushed, 0.06), pushUntilItEnters(&twin, 0.06));
  EXPECT_EQ(pushed.most, twin.most);
}

TEST(CuttingOnset, TheEnergyStoredBeforeIsSpentAndNoneIsGained) {
  Pushed pushed(toughSkin());
  double before = 0, work = 0;
  for (int k = 0; k < 160; ++k) {
    pushed.to(pushed.x + STRIDE, SPEED);
    EXPECT_LE(pushed.energy() - before, pushed.work - work + 1e-9) << pushed.x;
    before = pushed.energy();
    work = pushed.work;
  }
}

}  // namespace
}  // namespace incision
