#include <gtest/gtest.h>

#include <cmath>

#include "support/blade.h"
#include "support/cuts.h"
#include "support/tool.h"

namespace incision {
namespace {

constexpr double CELL = 0.125;  // edge of a cell of the block [m]; its elements are as large
constexpr double FACES = 0.25;  // a plane of mesh faces [m]

/// A block of 1 × 0.5 × 0.5 m, free and without gravity, and a blade along z that reaches through it.
Scene blockAndBlade(double cutting_force, bool progressive) {
  Scene scene;
  scene.body.grid = GridSettings{{8, 4, 4}, Vec3(1, 0.5, 0.5), Vec3::Zero()};
  scene.body.material = {1e5, 0.3, 1000, 0, 0};
  scene.gravity = Vec3::Zero();
  scene.solver.method = Method::DIRECT;
  scene.tools = {bladeTool(Edge{Vec3(0, 0, -0.1), Vec3(0, 0, 0.6)})};
  bladeOf(&scene.tools[0]).cutting.resistance.force = cutting_force;
  bladeOf(&scene.tools[0]).cutting.progressive = progressive;
  return scene;
}

/// The four blades that must agree: with and without a cutting force [N/m], with and without progressive opening.
class OldCut : public ::testing::TestWithParam<std::tuple<double, bool>> {
 protected:
  OldCut() : body(scene(), loadMesh(scene())) {}

  static Scene scene() { return blockAndBlade(std::get<0>(GetParam()), std::get<1>(GetParam())); }

  /// Draws the blade from x = −0.1 m on, beside or in what was cut before.
  template <typename Height>
  void drawAlongX(double to, const Height& height) {
    constexpr int MOVES = 30;
    for (int k = 0; k <= MOVES; ++k) {
      const double x = -0.1 + (to + 0.1) * k / MOVES;
      body.guideTool({poseAt(x, height(x))});
      const ToolReport report = body.step().tools[0];
      most = std::max(most, report.force.norm());
      area = report.stroke_area;
    }
    body.liftTool();
  }

  void expectItStaysInTheCut(const BodyCounts& before) {
    EXPECT_EQ(body.counts().parts, before.parts);
    EXPECT_EQ(body.counts().copies, before.copies);
    EXPECT_EQ(body.counts().cracks, before.cracks);
    EXPECT_EQ(most, 0);
    EXPECT_EQ(body.motion().max_displacement, 0);
    EXPECT_EQ(body.motion().kinetic_energy, 0);
  }

  DeformableBody body;
  double most = 0;  // force on the tool [N]
  double area = 0;  // cut by the last stroke [m²]
};

INSTANTIATE_TEST_SUITE_P(Blades, OldCut, ::testing::Combine(::testing::Values(0.0, 100.0), ::testing::Bool()));

TEST_P(OldCut, AlongMeshFacesKeepsABladeThatRunsInOrBesideIt) {
  body.cut(plane(Vec3(0, FACES, 0), Vec3::UnitY()));
  const BodyCounts before = body.counts();
  for (const double beside : {0.0, 0.0005, -0.0005, -0.1 * CELL}) {
    SCOPED_TRACE(beside);
    drawAlongX(1.1, [&](double) { return FACES + beside; });
    expectItStaysInTheCut(before);
  }
}

TEST_P(OldCut, AlongMeshFacesKeepsABladeThatCrossesItToAndFro) {
  body.cut(plane(Vec3(0, FACES, 0), Vec3::UnitY()));
  const BodyCounts before = body.counts();
  for (const double waves : {1, 5}) {
    SCOPED_TRACE(waves);
    drawAlongX(1.1, [&](double x) { return FACES + 0.0005 * std::sin(2 * M_PI * waves * x); });
    expectItStaysInTheCut(before);
  }
}

TEST_P(OldCut, ThroughElementsKeepsABladeThatRunsInOrBesideIt) {
  const double y = 0.3;
  body.cut(plane(Vec3(0, y, 0), Vec3::UnitY()));
  const BodyCounts before = body.counts();
  for (const double beside : {0.0, 0.0005}) {
    SCOPED_TRACE(beside);
    drawAlongX(1.1, [&](double) { return y + beside; });
    expectItStaysInTheCut(before);
  }
}

TEST_P(OldCut, BesideMeshFacesKeepsABladeThatRunsAlongThem) {
  for (const double beside : {0.04, -0.04, 0.15, -0.15}) {
    SCOPED_TRACE(beside);
    body.reset();
    body.cut(plane(Vec3(0, FACES + beside * CELL, 0), Vec3::UnitY()));
    const BodyCounts before = body.counts();
    for (const double height : {FACES, FACES + beside * CELL}) {
      drawAlongX(1.1, [&](double) { return height; });
      expectItStaysInTheCut(before);
    }
  }
}

TEST_P(OldCut, KeepsABladeThatGoesBackInIt) {
  body.cut(plane(Vec3(0, FACES, 0), Vec3::UnitY()));
  const BodyCounts before = body.counts();
  for (int k = 0; k <= 40; ++k) {
    body.guideTool({poseAt(0.4 + 0.3 * std::sin(0.2 * k), FACES + 0.0005)});
    most = std::max(most, body.step().tools[0].force.norm());
  }
  expectItStaysInTheCut(before);
}

TEST_P(OldCut, IsCrossedAtAnAngle) {
  body.cut(plane(Vec3(0, FACES, 0), Vec3::UnitY()));
  for (int k = 0; k <= 40; ++k) {
    const double s = k / 40.0;
    body.guideTool({poseAt(0.3 + 0.4 * s, -0.1 + 0.7 * s)});
    body.step();
  }
  body.liftTool();
  EXPECT_GE(body.counts().cracks, 2);
  EXPECT_EQ(body.counts().pieces, 4);
}

TEST_P(OldCut, DoesNotKeepABladeThatRunsFartherOff) {
  body.cut(plane(Vec3(0, FACES, 0), Vec3::UnitY()));
  drawAlongX(1.1, [&](double) { return FACES + 0.4 * CELL; });
  EXPECT_EQ(body.counts().cracks, 2);
  EXPECT_EQ(body.counts().pieces, 3);
}

TEST_P(OldCut, LetsAStrokeGoOnBeyondItsEnd) {
  for (const double beside : {0.0, 0.0005}) {
    SCOPED_TRACE(beside);
    body.reset();
    most = 0;
    body.cut(rectangle(Vec3(0, FACES, 0.25), Vec3::UnitY(), Vec3::UnitX(), 1, 2));  // to x = 0.5 m
    ASSERT_EQ(body.counts().pieces, 1);
    const BodyCounts before = body.counts();
    drawAlongX(0.45, [&](double) { return FACES + beside; });
    expectItStaysInTheCut(before);
    drawAlongX(1.1, [&](double) { return FACES + beside; });
    EXPECT_EQ(body.counts().cracks, 2);
    EXPECT_NEAR(area, 0.5 * 0.5, 0.1 * 0.5 * 0.5);
    Scene shown = scene();
    if (beside == 0 && bladeOf(&shown.tools[0]).cutting.resistance.force == 0) {
      EXPECT_EQ(body.counts().pieces, 2);
    }
  }
}

}  // namespace
}  // namespace incision
