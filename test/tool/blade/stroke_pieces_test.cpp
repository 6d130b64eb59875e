#include <gtest/gtest.h>

#include "support/blade.h"
#include "support/tool.h"

namespace incision {
namespace {

double sum(const std::vector<double>& values) {
  double total = 0;
  for (const double value : values) total += value;
  return total;
}

/// Round a circle of 0.15 m in the plate's middle, so many times.
std::vector<Pose> circle(double turns, int moves) {
  return along(moves, [=](double s) {
    const double angle = 2 * M_PI * turns * s;
    return poseAt(0.5 + 0.15 * std::cos(angle), 0.26 + 0.15 * std::sin(angle));
  });
}

TEST(StrokePieces, AClosedLoopFreesItsPlugWhereElementsAreCutWhole) {
  Scene scene = plateAndBlade(8);
  bladeOf(&scene.tools[0]).cutting.progressive = false;
  DeformableBody body(scene, loadMesh(scene));
  draw(&body, circle(1.15, 150));  // it overshoots
  const std::vector<double> volumes = body.pieceVolumes();
  ASSERT_EQ(volumes.size(), 2u);
  // The crack is a plane in each element, along the way where the blade comes to it: over an element of size h that is
  // h²/2r beside the circle.
  const double plug = M_PI * 0.15 * 0.15 * 0.25, stray = cellOf(scene) * cellOf(scene) / (2 * 0.15);
  EXPECT_NEAR(volumes[0], plug, stray * 2 * M_PI * 0.15 * 0.25);
  EXPECT_NEAR(sum(volumes), 0.125, 1e-12);
}

// Progressive cuts take the direction of each element where the blade enters it, so elements have to be smaller beside
// the path's radius: here two and a half. Over an element's diagonal d² = 2 h² the circle leaves that by d²/2r.
TEST(StrokePieces, AClosedLoopFreesItsPlug) {
  const Scene scene = plateAndBlade(16);
  for (const int moves : {40, 150}) {
    DeformableBody body(scene, loadMesh(scene));
    draw(&body, circle(1.15, moves), 200);  // in one step
    body.step();
    const std::vector<double> volumes = body.pieceVolumes();
    ASSERT_EQ(volumes.size(), 2u) << moves;
    const double plug = M_PI * 0.15 * 0.15 * 0.25, stray = cellOf(scene) * cellOf(scene) / 0.15;
    EXPECT_NEAR(volumes[0], plug, stray * 2 * M_PI * 0.15 * 0.25);
  }
}

TEST(StrokePieces, ASharpCornerFreesTheCornerOfThePlate) {
  const Scene scene = plateAndBlade(8);
  for (const int moves : {24, 240}) {
    DeformableBody body(scene, loadMesh(scene));
    draw(&body, along(moves, [](double s) {
      return s < 0.5 ? poseAt(0.33, -0.05 + 0.62 * s) : poseAt(0.33 - 0.8 * (s - 0.5), 0.26);
    }));
    const std::vector<double> volumes = body.pieceVolumes();
    ASSERT_EQ(volumes.size(), 2u) << moves;
    // The corner itself is cut within an element.
    EXPECT_NEAR(volumes[0], 0.33 * 0.26 * 0.25, cellOf(scene) * cellOf(scene) * 0.25) << moves;
  }
}

TEST(StrokePieces, CrossingAnEarlierStrokeMakesFour) {
  const Scene scene = plateAndBlade();
  for (const int moves : {12, 150}) {
    DeformableBody body(scene, loadMesh(scene));
    draw(&body, along(moves, [](double s) { return poseAt(-0.1 + 1.2 * s, 0.11 + 0.3 * s); }));
    body.liftTool();
    draw(&body, along(moves, [](double s) { return poseAt(0.63 - 0.2 * s, -0.1 + 0.7 * s); }));
    EXPECT_EQ(body.counts().pieces, 4) << moves;
    EXPECT_EQ(body.counts().cracks, 2) << moves;
    EXPECT_NEAR(sum(body.pieceVolumes()), 0.125, 1e-12);
  }
}

TEST(StrokePieces, TheFrontStaysWhereTheBladeStops) {
  const Scene scene = plateAndBlade();
  DeformableBody body(scene, loadMesh(scene));
  draw(&body, along(60, [](double s) { return poseAt(-0.1 + 0.6 * s, 0.21); }));
  const BodyCounts counts = body.counts();
  const std::uint64_t version = body.topologyVersion();
  for (int k = 0; k < 200; ++k) body.step();
  EXPECT_EQ(body.topologyVersion(), version);
  EXPECT_EQ(counts.pieces, 1);
  for (const Vec3& X : cutCorners(body.mesh())) EXPECT_LT(X.x(), 0.5 + cellOf(scene));
  EXPECT_NEAR(body.step().tools[0].stroke_area, 0.5 * 0.25, 0.02 * 0.125);
}

TEST(StrokePieces, AStillBladeCutsTissueThatIsDrawnOverIt) {
  Scene scene = plateAndBlade();
  scene.body.material = {1e8, 0.3, 1, 0, 0};  // stiff and light: it moves as one
  scene.boundary = {{{Vec3(1 - 1e-6, -1, -1), Vec3(2, 1, 1)}, Vec3(-1, 0, 0)}};
  DeformableBody body(scene, loadMesh(scene));
  body.placeTool(poseAt(-0.105, 0.21));
  for (int k = 0; k < 60; ++k) body.step();
  EXPECT_EQ(body.counts().cracks, 1);
  double reach = 0;
  for (const Vec3& X : cutCorners(body.mesh())) {
    EXPECT_NEAR(X.y(), 0.21, 0.02 * cellOf(scene));
    reach = std::max(reach, X.x());
  }
  EXPECT_NEAR(reach, 0.495, cellOf(scene));
}

TEST(StrokePieces, ABladePutIntoTissueCutsOnlyWhereItGoesFromThere) {
  const Scene scene = plateAndBlade(8);
  DeformableBody body(scene, loadMesh(scene));
  body.placeTool(poseAt(0.5, 0.26));
  for (int k = 0; k < 5; ++k) body.step();
  EXPECT_EQ(body.counts().cracks, 0);
  draw(&body, along(30, [](double s) { return poseAt(0.5 + 0.25 * s, 0.26); }));
  EXPECT_EQ(body.counts().pieces, 1);
  EXPECT_EQ(body.counts().cracks, 1);
  for (const Vec3& X : cutCorners(body.mesh())) {
    EXPECT_GT(X.x(), 0.5 - cellOf(scene));
    EXPECT_LT(X.x(), 0.75 + cellOf(scene));
  }
}

TEST(StrokePieces, ABladeThatIsOffCutsNothing) {
  const Scene scene = plateAndBlade();
  DeformableBody body(scene, loadMesh(scene));
  body.activateTool(false);
  draw(&body, along(30, [](double s) { return poseAt(-0.1 + 0.6 * s, 0.21); }));
  EXPECT_EQ(body.counts().cracks, 0);
  body.activateTool(true);
  draw(&body, along(30, [](double s) { return poseAt(0.5 + 0.6 * s, 0.21); }));
  EXPECT_EQ(body.counts().cracks, 1);
  for (const Vec3& X : cutCorners(body.mesh())) EXPECT_GT(X.x(), 0.5 - cellOf(scene));
  EXPECT_EQ(body.counts().pieces, 1);
}

}  // namespace
}  // namespace incision
