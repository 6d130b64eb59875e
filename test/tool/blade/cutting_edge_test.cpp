#include "incision/tool/blade/cutting_edge.h"

#include <gtest/gtest.h>

#include <vector>

#include "support/blade.h"
#include "support/sanitized.h"
#include "support/tool.h"

namespace incision {
namespace {

constexpr double FORCE = 100;   // [N/m]
constexpr double HEIGHT = 0.1;  // of the block along the edge [m]

/// Cells across the block, and speeds of the edge [m/s].
const std::vector<int> CELLS = test::SANITIZED ? std::vector<int>{3} : std::vector<int>{3, 5};
const std::vector<double> SPEEDS = test::SANITIZED ? std::vector<double>{0.5} : std::vector<double>{0.02, 0.1, 0.5};

/// A block of 0.2 × 0.1 × 0.1 m, held at its far end, and an edge along z through it that comes along x.
Scene blockAndEdge(int cells = 3, double force = FORCE) {
  Scene scene;
  scene.body.grid = GridSettings{{2 * cells, cells, cells}, Vec3(0.2, 0.1, HEIGHT), Vec3(0, -0.05, 0)};
  scene.body.material = {1e5, 0.3, 1000, 20, 0};
  scene.gravity = Vec3::Zero();
  scene.boundary = {{{Vec3(0.2 - 1e-6, -1, -1), Vec3(1, 1, 1)}, Vec3::Zero()}};
  scene.solver.method = Method::DIRECT;
  scene.tools = {bladeTool(Edge{Vec3(0, 0, -0.05), Vec3(0, 0, 0.15)})};
  bladeOf(&scene.tools[0]).cutting_force = force;
  return scene;
}

constexpr double Y = 0.004;  // off the planes of nodes

/// A body whose blade is pushed along x, with what that took.
struct Pushed {
  explicit Pushed(const Scene& scene, double from = -0.02) : body(scene, loadMesh(scene)), x(from) {
    body.placeTool(poseAt(x, Y));
  }
  void to(double end, double speed) {
    const double dt = body.scene().solver.time_step;
    const int steps = static_cast<int>(std::ceil(std::abs(end - x) / (speed * dt) - 1e-9));
    const double move = (end - x) / steps;
    for (int k = 0; k < steps; ++k) {
      x += move;
      body.guideTool({poseAt(x, Y)});
      report = body.step().tools[0];
      work -= report.force.x() * move;
      most = std::max(most, report.force.norm());
      momentum += dt * report.force;
    }
  }
  double energy() const { return body.motion().elastic_energy + body.motion().kinetic_energy; }

  DeformableBody body;
  double x, work = 0, most = 0;
  Vec3 momentum = Vec3::Zero();  // that the tool has got
  ToolReport report;
};

TEST(CuttingEdge, BeforeItComesToTheTissueItFeelsNothing) {
  Pushed pushed(blockAndEdge());
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
    EXPECT_GT(pushed.report.force.x(), -force * HEIGHT) << x;
    // It slips a twentieth of what the tissue gives way.
    EXPECT_LT(pushed.report.stroke_area, 0.1 * HEIGHT * x) << x;
  }
}

TEST(CuttingEdge, AdvancesAgainstTheCuttingForceTimesItsLengthInTheTissue) {
  for (const int cells : CELLS) {
    Pushed pushed(blockAndEdge(cells));
    pushed.to(0.04, 0.05);
    for (const double x : {0.05, 0.06, 0.07, 0.09, 0.11}) {
      pushed.to(x, 0.05);
      EXPECT_NEAR(pushed.report.force.x(), -FORCE * HEIGHT, 0.03 * FORCE * HEIGHT) << cells << " " << x;
      EXPECT_LT(pushed.report.force.tail<2>().norm(), 0.05 * FORCE * HEIGHT) << cells << " " << x;
    }
  }
}

TEST(CuttingEdge, ARegionMayTakeAnotherForce) {
  Scene scene = blockAndEdge();
  RegionSettings tough;
  tough.place = {Vec3(0.08, -1, -1), Vec3(0.14, 1, 1)};
  tough.cutting_force = 2.5 * FORCE;
  scene.body.regions = {tough};
  Pushed pushed(scene);
  pushed.to(0.05, 0.05);
  EXPECT_NEAR(pushed.report.force.x(), -FORCE * HEIGHT, 0.03 * FORCE * HEIGHT);
  pushed.to(0.11, 0.05);
  EXPECT_NEAR(pushed.report.force.x(), -2.5 * FORCE * HEIGHT, 0.03 * FORCE * HEIGHT);
}

TEST(CuttingEdge, TheWorkIsTheAreaTimesTheFractureEnergy) {
  for (const int cells : CELLS)
    for (const double speed : SPEEDS) {
      Pushed pushed(blockAndEdge(cells));
      pushed.to(0.03, speed);
      const double work = pushed.work, energy = pushed.energy(), area = pushed.report.stroke_area;
      pushed.to(0.13, speed);
      const double spent = pushed.work - work - (pushed.energy() - energy);
      const double cut = pushed.report.stroke_area - area;
      EXPECT_NEAR(spent, FORCE * cut, 0.03 * FORCE * cut) << cells << " " << speed;
      EXPECT_NEAR(cut, 0.1 * HEIGHT, 0.03 * 0.1 * HEIGHT) << cells << " " << speed;
    }
}

TEST(CuttingEdge, TheWorkOfAWholeStrokeCountsFromTheSkin) {
  for (const int cells : CELLS) {
    Pushed pushed(blockAndEdge(cells));
    pushed.to(0.06, 0.05);
    const double spent = pushed.work - pushed.energy(), area = pushed.report.stroke_area;
    // Below it is what the edge slips elastically; an element's section is known to a hundredth of it.
    EXPECT_NEAR(spent, FORCE * area, 0.05 * FORCE * area) << cells;
  }
}

TEST(CuttingEdge, GoingBackItIsFree) {
  Pushed pushed(blockAndEdge());
  pushed.to(0.08, 0.05);
  const double area = pushed.report.stroke_area;
  pushed.to(0.07, 0.05);  // the tissue has sprung back
  pushed.most = 0;
  pushed.to(-0.02, 0.05);
  EXPECT_LT(pushed.most, 1e-9 * FORCE);
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
  pushed.body.placeTool(poseAt(pushed.x, Y));
  pushed.most = 0;
  pushed.to(0.06, 0.05);
  EXPECT_LT(pushed.most, 0.01 * force * HEIGHT);
  EXPECT_EQ(pushed.body.counts().parts, counts.parts);
  EXPECT_EQ(pushed.body.counts().cracks, 1);
  pushed.to(0.12, 0.05);
  EXPECT_NEAR(pushed.report.force.x(), -force * HEIGHT, 0.03 * force * HEIGHT);
}

TEST(CuttingEdge, WithoutACuttingForceItIsFree) {
  Pushed pushed(blockAndEdge(3, 0));
  pushed.to(0.08, 0.05);
  EXPECT_EQ(pushed.most, 0);
  EXPECT_TRUE(pushed.report.touching);
  EXPECT_NEAR(pushed.report.stroke_area, 0.08 * HEIGHT, 0.03 * 0.08 * HEIGHT);
}

/// The block, and a box as blade that is pushed into it along its edge, at y = 0.004 m and z = 0.047 m.
struct Stabbed {
  static constexpr double THICKNESS = 0.004;  // [m]

  explicit Stabbed(bool with_shape, int cells = 3)
      : body(scene(with_shape, cells), loadMesh(scene(with_shape, cells)),
             with_shape ? description() : Descriptions()) {
    body.placeTool(poseAt(x, Y, 0.047));
  }

  static Scene scene(bool with_shape, int cells) {
    Scene scene = blockAndEdge(cells, FORCE_OF_TIP);
    scene.body.material.stiffness_damping = 0.02;
    bladeOf(&scene.tools[0]).edge = Edge{Vec3(-0.3, 0, 0), Vec3(0, 0, 0)};
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
      body.guideTool({poseAt(x, Y, 0.047)});
      report = body.step().tools[0];
    }
    return report.force;
  }

  static constexpr double FORCE_OF_TIP = 500;  // [N/m]
  DeformableBody body;
  double x = -0.01;
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

TEST(CuttingEdge, PushedAlongItselfWithoutAShapeItIsFree) {
  Stabbed stabbed(false);
  EXPECT_LT(stabbed.to(0.07).norm(), 1e-9 * Stabbed::FORCE_OF_TIP * Stabbed::THICKNESS);
}

TEST(CuttingEdge, BodyAndToolKeepTheirMomentum) {
  Scene scene = blockAndEdge();
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
