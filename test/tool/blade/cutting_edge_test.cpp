#include "incision/tool/blade/cutting_edge.h"

#include <gtest/gtest.h>

#include <vector>

#include "support/pushed_blade.h"
#include "support/sanitized.h"

namespace incision {
namespace {

constexpr double PLAIN_FORCE = 100;  // [N/m]

/// Cells across the block, and speeds of the edge [m/s].
const std::vector<int> CELLS = test::SANITIZED ? std::vector<int>{3} : std::vector<int>{3, 5};
const std::vector<double> SPEEDS = test::SANITIZED ? std::vector<double>{0.5} : std::vector<double>{0.02, 0.1, 0.5};

TEST(CuttingEdge, BeforeItComesToTheTissueItFeelsNothing) {
  Pushed pushed(blockAndEdge(3, PLAIN_FORCE));
  pushed.to(-0.001, 0.05);
  EXPECT_EQ(pushed.most, 0);
  EXPECT_FALSE(pushed.report.touching);
}

TEST(CuttingEdge, BelowTheCuttingForceTheTissueGivesWayLinearlyUncut) {
  const double force = 4000;
  Pushed pushed(blockAndEdge(3, force), 0);
  double first = 0;
  for (int k = 1; k <= 4; ++k) {
    const double x = 0.002 * k;
    pushed.to(x, 0.02);
    for (int rest = 0; rest < 100; ++rest) pushed.report = pushed.body.step().tools[0];
    if (k == 1) first = pushed.report.force.x();
    EXPECT_LT(pushed.report.force.x(), -1) << x;
    EXPECT_NEAR(pushed.report.force.x(), k * first, 0.1 * std::abs(k * first)) << x;
    EXPECT_GT(pushed.report.force.x(), -force * BLOCK_HEIGHT) << x;
    // It slips a twentieth of what the tissue gives way.
    EXPECT_LT(pushed.report.stroke_area, 0.1 * BLOCK_HEIGHT * x) << x;
  }
}

TEST(CuttingEdge, AdvancesAgainstTheCuttingForceTimesItsLengthInTheTissue) {
  for (const int cells : CELLS) {
    Pushed pushed(blockAndEdge(cells, PLAIN_FORCE));
    pushed.to(0.04, 0.05);
    for (const double x : {0.05, 0.06, 0.07, 0.09, 0.11}) {
      pushed.to(x, 0.05);
      EXPECT_NEAR(pushed.report.force.x(), -PLAIN_FORCE * BLOCK_HEIGHT, 0.03 * PLAIN_FORCE * BLOCK_HEIGHT)
          << cells << " " << x;
      EXPECT_LT(pushed.report.force.tail<2>().norm(), 0.05 * PLAIN_FORCE * BLOCK_HEIGHT) << cells << " " << x;
    }
  }
}

TEST(CuttingEdge, ARegionMayTakeAnotherForce) {
  Scene scene = blockAndEdge(3, PLAIN_FORCE);
  RegionSettings tough;
  tough.place = {Vec3(0.08, -1, -1), Vec3(0.14, 1, 1)};
  tough.cutting_force = 2.5 * PLAIN_FORCE;
  scene.body.regions = {tough};
  Pushed pushed(scene);
  pushed.to(0.05, 0.05);
  EXPECT_NEAR(pushed.report.force.x(), -PLAIN_FORCE * BLOCK_HEIGHT, 0.03 * PLAIN_FORCE * BLOCK_HEIGHT);
  pushed.to(0.11, 0.05);
  EXPECT_NEAR(pushed.report.force.x(), -2.5 * PLAIN_FORCE * BLOCK_HEIGHT, 0.03 * PLAIN_FORCE * BLOCK_HEIGHT);
}

TEST(CuttingEdge, TheWorkIsTheAreaTimesTheFractureEnergy) {
  for (const int cells : CELLS)
    for (const double speed : SPEEDS) {
      Pushed pushed(blockAndEdge(cells, PLAIN_FORCE));
      pushed.to(0.03, speed);
      const double work = pushed.work, energy = pushed.energy(), area = pushed.report.stroke_area;
      pushed.to(0.13, speed);
      const double spent = pushed.work - work - (pushed.energy() - energy);
      const double cut = pushed.report.stroke_area - area;
      EXPECT_NEAR(spent, PLAIN_FORCE * cut, 0.03 * PLAIN_FORCE * cut) << cells << " " << speed;
      EXPECT_NEAR(cut, 0.1 * BLOCK_HEIGHT, 0.03 * 0.1 * BLOCK_HEIGHT) << cells << " " << speed;
    }
}

TEST(CuttingEdge, TheWorkOfAWholeStrokeCountsFromTheSkin) {
  for (const int cells : CELLS) {
    Pushed pushed(blockAndEdge(cells, PLAIN_FORCE));
    pushed.to(0.06, 0.05);
    const double spent = pushed.work - pushed.energy(), area = pushed.report.stroke_area;
    // Below it is what the edge slips elastically; an element's section is known to a hundredth of it.
    EXPECT_NEAR(spent, PLAIN_FORCE * area, 0.05 * PLAIN_FORCE * area) << cells;
  }
}

TEST(CuttingEdge, GoingBackItIsFree) {
  Pushed pushed(blockAndEdge(3, PLAIN_FORCE));
  pushed.to(0.08, 0.05);
  const double area = pushed.report.stroke_area;
  pushed.to(0.07, 0.05);  // the tissue has sprung back
  pushed.most = 0;
  pushed.to(-0.02, 0.05);
  EXPECT_LT(pushed.most, 1e-9 * PLAIN_FORCE);
  EXPECT_NEAR(pushed.report.stroke_area, area, 1e-3 * area);
}

TEST(CuttingEdge, InTheSlitOfAnEarlierStrokeItIsFree) {
  const double force = 0.1;  // so little that the slit lies where the blade has been, within SNAP
  Pushed pushed(blockAndEdge(3, force));
  pushed.to(0.08, 0.05);
  const BodyCounts counts = pushed.body.counts();
  pushed.body.liftTool();
  for (int k = 0; k < 200; ++k) pushed.body.step();
  pushed.x = -0.02;
  pushed.body.placeTool(poseAt(pushed.x, PUSHED_AT));
  pushed.most = 0;
  pushed.to(0.06, 0.05);
  EXPECT_LT(pushed.most, 0.01 * force * BLOCK_HEIGHT);
  EXPECT_EQ(pushed.body.counts().parts, counts.parts);
  EXPECT_EQ(pushed.body.counts().cracks, 1);
  pushed.to(0.12, 0.05);
  EXPECT_NEAR(pushed.report.force.x(), -force * BLOCK_HEIGHT, 0.03 * force * BLOCK_HEIGHT);
}

TEST(CuttingEdge, WithoutACuttingForceItIsFree) {
  Pushed pushed(blockAndEdge(3, 0));
  pushed.to(0.08, 0.05);
  EXPECT_EQ(pushed.most, 0);
  EXPECT_TRUE(pushed.report.touching);
  EXPECT_NEAR(pushed.report.stroke_area, 0.08 * BLOCK_HEIGHT, 0.03 * 0.08 * BLOCK_HEIGHT);
}

/// The block, and a box as blade that is pushed into it along its edge, at y = 0.004 m and z = 0.047 m.
struct Stabbed {
  static constexpr double THICKNESS = 0.004;  // [m]

  explicit Stabbed(bool with_shape, int cells = 3, double onset = 0)
      : body(scene(with_shape, cells, onset), loadMesh(scene(with_shape, cells)),
             with_shape ? description() : Descriptions()) {
    body.placeTool(poseAt(x, PUSHED_AT, 0.047));
  }

  static Scene scene(bool with_shape, int cells, double onset = 0) {
    Scene scene = blockAndEdge(cells, FORCE_OF_TIP);
    scene.body.material.stiffness_damping = 0.02;
    bladeOf(&scene.tools[0]).edge = Edge{Vec3(-0.3, 0, 0), Vec3(0, 0, 0)};
    bladeOf(&scene.tools[0]).cutting.resistance.onset = onset;
    scene.tools[0].friction = 0;
    if (with_shape) scene.tools[0].description = "blade.urdf";
    return scene;
  }
  static Descriptions description() {
    return {{"<robot name='tool'><link name='blade'><collision><origin xyz='-0.15 0 0.01'/>"
             "<geometry><box size='0.3 0.004 0.02'/></geometry></collision></link></robot>"},
            ""};
  }

  Vec3 to(double end) {
    ToolReport report;
    while (std::abs(end - x) > 1e-9) {
      x += std::clamp(end - x, -5e-4, 5e-4);
      body.guideTool({poseAt(x, PUSHED_AT, 0.047)});
      report = body.step().tools[0];
      most = std::max(most, report.force.norm());
    }
    return report.force;
  }

  static constexpr double FORCE_OF_TIP = 500;  // [N/m]
  DeformableBody body;
  double x = -0.01, most = 0;
};

TEST(CuttingEdge, PushedAlongItselfAdvancesAgainstTheCuttingForceTimesTheThicknessOfItsTip) {
  for (const int cells : CELLS) {
    Stabbed stabbed(true, cells);
    EXPECT_EQ(stabbed.to(-0.001), Vec3::Zero());
    const double force = Stabbed::FORCE_OF_TIP * Stabbed::THICKNESS;
    for (const double x : {0.05, 0.07, 0.09}) {
      const Vec3 felt = stabbed.to(x);
      EXPECT_NEAR(felt.x(), -force, 0.01 * force) << cells << " " << x;
      EXPECT_LT(felt.tail<2>().norm(), 0.05 * force) << cells << " " << x;
    }
    stabbed.to(0.085);  // the tissue has sprung back
    EXPECT_LT(std::abs(stabbed.to(0.08).x()), 1e-9 * force) << cells;
  }
}

TEST(CuttingEdge, PushedAlongItselfTakesTheOnsetOnce) {
  const double onset = 1000, force = Stabbed::FORCE_OF_TIP * Stabbed::THICKNESS;
  Stabbed stabbed(true, 3, onset);
  stabbed.to(0.05);
  const double first = force + onset * Stabbed::THICKNESS;
  EXPECT_GE(stabbed.most, first);
  EXPECT_LT(stabbed.most, 1.1 * first);  // more by what the last step has brought
  for (const double x : {0.07, 0.09}) EXPECT_NEAR(stabbed.to(x).x(), -force, 0.01 * force) << x;
}

TEST(CuttingEdge, PushedAlongItselfWithoutAShapeItIsFree) {
  Stabbed stabbed(false);
  EXPECT_LT(stabbed.to(0.07).norm(), 1e-9 * Stabbed::FORCE_OF_TIP * Stabbed::THICKNESS);
}

TEST(CuttingEdge, BodyAndToolKeepTheirMomentum) {
  Scene scene = blockAndEdge(3, PLAIN_FORCE);
  scene.boundary.clear();
  scene.body.material.mass_damping = 0;
  scene.body.material.stiffness_damping = 0.01;
  Pushed pushed(scene);
  const double mass = pushed.body.motion().mass;
  pushed.to(0.15, 0.5);
  EXPECT_GT(pushed.report.stroke_area, 0);
  EXPECT_GT(pushed.momentum.norm(), 0.01);
  EXPECT_LT((pushed.momentum + pushed.body.motion().momentum).norm(), 1e-10 * mass);
}

}  // namespace
}  // namespace incision
