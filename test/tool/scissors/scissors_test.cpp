#include "incision/tool/scissors/scissors.h"

#include <gtest/gtest.h>

#include <cmath>

#include "incision/base/input_error.h"
#include "incision/body/deformable_body.h"
#include "incision/mesh/grid_mesh.h"

namespace incision {
namespace {

constexpr double OVERLAP = 0.004;             // by which the edges pass each other where the joint is at 0, each [m]
constexpr double NEAR = 0.03, FAR = 0.07;     // of the strip from the pivot [m]
constexpr double WIDTH = 0.04, DEPTH = 0.01;  // of the strip across and along the closing [m]
constexpr double CUTTING_FORCE = 20;          // [N/m]
constexpr double OPEN = 0.3;                  // [rad]

/// Two blades of 0.1 m along x, which close in the plane y = 0 and slide past each other 1 mm on either side of it. One
/// of them may stay with the link.
std::string urdf(bool both = true) {
  const auto blade = [](const std::string& name, double y, double z) {
    return "<link name='" + name + "'><collision><origin xyz='0.05 " + std::to_string(y) + " " + std::to_string(z) +
           "'/><geometry><box size='0.1 0.002 0.006'/></geometry></collision></link>";
  };
  const auto joint = [](const std::string& name, const std::string& child, const std::string& type) {
    return "<joint name='" + name + "' type='" + type + "'><parent link='palm'/><child link='" + child +
           "'/><axis xyz='0 -1 0'/><limit lower='0' upper='1' effort='1' velocity='1'/>";
  };
  return "<robot name='shears'><link name='palm'/>" + blade("upper", 0.001, 0.003 - OVERLAP) +
         blade("lower", -0.001, OVERLAP - 0.003) + joint("jaw", "upper", "revolute") + "</joint>" +
         joint("other", "lower", both ? "revolute" : "fixed") + (both ? "<mimic joint='jaw' multiplier='-1'/>" : "") +
         "</joint></robot>";
}

ToolSettings shears() {
  ToolSettings tool;
  tool.name = "shears";
  tool.description = "shears.urdf";
  tool.link = "palm";
  tool.friction = 0;
  tool.kind = ScissorsSettings{CUTTING_FORCE};
  tool.jaw.emplace().joint = "jaw";
  return tool;
}

/// A strip along y between the blades, held at both its ends.
Scene strip(double young_modulus, bool progressive = true, std::array<int, 3> cells = {8, 8, 2}) {
  Scene scene;
  scene.body.grid = GridSettings{cells, Vec3(FAR - NEAR, WIDTH, DEPTH), Vec3(NEAR, -WIDTH / 2 + 0.0013, -DEPTH / 2)};
  scene.body.material = {young_modulus, 0.3, 1000, 0, 0.002};
  scene.gravity.setZero();
  const double low = -WIDTH / 2 + 0.0013;
  scene.boundary = {{Place(Vec3(-1, -1, -1), Vec3(1, low + 1e-6, 1)), Vec3::Zero()},
                    {Place(Vec3(-1, low + WIDTH - 1e-6, -1), Vec3(1, 1, 1)), Vec3::Zero()}};
  scene.solver.method = Method::DIRECT;
  scene.solver.time_step = 0.005;
  scene.tools = {shears()};
  std::get<ScissorsSettings>(scene.tools[0].kind).cutting.progressive = progressive;
  return scene;
}

/// The shears, at the origin or elsewhere, close on the strip.
struct Cutting {
  explicit Cutting(const Scene& scene, const std::string& description = urdf(), const Pose& link = {},
                   double open = OPEN)
      : body(scene, loadMesh(scene), {{description}, ""}), angle(open) {
    body.placeTool(link);
    body.guideJaw(angle);
    body.step();
  }

  /// In steps of `turn`.
  void closeTo(double end, double turn = 0.002) {
    while (angle > end) {
      const double next = std::max(end, angle - turn);
      body.guideJaw(next);
      const StepResult step = body.step();
      work += step.tools[0].jaw_torque * (angle - next);
      area = step.tools[0].stroke_area;
      angle = next;
      for (const CutResult& cut : step.cuts) reports.push_back(cut);
      if (parted < 0 && body.counts().pieces > 1) parted = angle;
    }
  }

  DeformableBody body;
  double angle, work = 0, area = 0, parted = -1;
  std::vector<CutResult> reports;
};

TEST(ScissorEdges, LieInOnePlaneWhereTheBladesPassEachOther) {
  for (bool both : {true, false}) {
    const JawLinks links(parseDescription(urdf(both), "shears.urdf"), "palm", "jaw");
    const ScissorEdges found = scissorEdges(links, "");
    for (int i = 0; i < 2; ++i) {
      const Edge edge = placed(found.edges[i].edge, links.pose(found.edges[i].group, 0));
      for (const Vec3& end : edge) {
        EXPECT_NEAR(end.y(), 0, 1e-12);
        EXPECT_NEAR(end.z(), i == 0 ? -OVERLAP : OVERLAP, 1e-12);
      }
      EXPECT_NEAR((edge[1] - edge[0]).norm(), 0.1, 1e-12);
      EXPECT_NEAR(found.thickness[i], 0.002, 1e-12);
    }
  }
}

// The edges cross where x tan(angle) = OVERLAP: the strip is cut through when that is at its far side.
TEST(Scissors, CutAStripThroughAtTheAngleOfTheirGeometry) {
  const double through = std::atan(OVERLAP / FAR), before = std::atan(OVERLAP / (FAR - (FAR - NEAR) / 8));
  for (double young_modulus : {1e5, 1e7})
    for (bool progressive : {true, false}) {
      Cutting cutting(strip(young_modulus, progressive));
      cutting.closeTo(0);
      EXPECT_GE(cutting.parted, through - 0.003) << young_modulus << " " << progressive;
      EXPECT_LE(cutting.parted, before + 0.003) << young_modulus << " " << progressive;
      EXPECT_EQ(cutting.body.counts().pieces, 2);
      EXPECT_NEAR(cutting.area, (FAR - NEAR) * DEPTH, 1e-3 * (FAR - NEAR) * DEPTH);
    }
}

// What the edges do not feel is where they meet: a share of an element.
TEST(Scissors, TakeTheWorkOfTheCutArea) {
  Cutting cutting(strip(1e6, true, {12, 12, 3}));
  cutting.closeTo(0);
  const double expected = CUTTING_FORCE * (FAR - NEAR) * DEPTH;
  EXPECT_NEAR(cutting.work, expected, 0.03 * expected);
}

TEST(Scissors, WithAnOnsetAndAViscosityTakeMoreWorkForTheSameCut) {
  Scene scene = strip(1e6);
  auto& shears = std::get<ScissorsSettings>(scene.tools[0].kind);
  shears.cutting.resistance.viscosity = CUTTING_FORCE;  // as much again at 1 m/s
  shears.cutting.resistance.onset = CUTTING_FORCE;
  Cutting cutting(scene), without(strip(1e6));
  cutting.closeTo(0);
  without.closeTo(0);
  EXPECT_EQ(cutting.body.counts().pieces, 2);
  EXPECT_NEAR(cutting.area, (FAR - NEAR) * DEPTH, 1e-3 * (FAR - NEAR) * DEPTH);
  EXPECT_GT(cutting.work, 1.01 * without.work);
}

TEST(Scissors, ReportOneStrokeWhenTheyAreClosed) {
  Cutting cutting(strip(1e6));
  cutting.closeTo(0);
  cutting.body.guideJaw(0);
  for (const CutResult& cut : cutting.body.step().cuts) cutting.reports.push_back(cut);
  ASSERT_EQ(cutting.reports.size(), 1u);
  EXPECT_EQ(cutting.reports[0].label, "shears");
  EXPECT_EQ(cutting.reports[0].status, CutStatus::APPLIED);
  EXPECT_EQ(cutting.reports[0].cracks, 1);
  EXPECT_EQ(cutting.reports[0].pieces, 2);
}

TEST(Scissors, HalfClosedTheyLeaveAHinge) {
  Cutting cutting(strip(1e6));
  cutting.closeTo(std::atan(OVERLAP / 0.05));
  EXPECT_EQ(cutting.body.counts().pieces, 1);
  EXPECT_GT(cutting.area, 0.6 * (FAR - NEAR) * DEPTH);
}

// The blade that stays lies below the strip; the other comes down to it.
TEST(Scissors, WithOneBladeThatStaysCutToo) {
  Pose below;
  below.position.z() = -DEPTH / 2 - OVERLAP;
  Cutting cutting(strip(1e6), urdf(false), below, 0.8);
  cutting.closeTo(0);
  EXPECT_EQ(cutting.body.counts().pieces, 2);
  EXPECT_NEAR(cutting.area, (FAR - NEAR) * DEPTH, 1e-3 * (FAR - NEAR) * DEPTH);
}

TEST(Scissors, OpeningCutNothing) {
  Scene scene = strip(1e6);
  Cutting cutting(scene);
  cutting.closeTo(0.2);
  const int parts = cutting.body.counts().parts;
  cutting.body.guideJaw(0.8);
  cutting.body.step();
  EXPECT_EQ(cutting.body.counts().parts, parts);
}

// They lie closed in a slit; as they open, its faces are pressed apart and press them together, and nothing is cut.
TEST(Scissors, OpeningSpreadTissue) {
  Scene scene = strip(1e4);
  scene.contact.emplace();
  scene.contact->friction = 0;
  scene.boundary = {{Place(Vec3(-1, -1, -1), Vec3(1, 1, -DEPTH / 2 + 1e-6)), Vec3::Zero()},
                    {Place(Vec3(-1, -1, DEPTH / 2 - 1e-6), Vec3(1, 1, 1)), Vec3::Zero()}};
  scene.cuts = {{0, {"slit", Vec3::Zero(), Vec3(0, 0, 1), Vec3::Zero(), 0, 0}}};
  Cutting cutting(scene);
  cutting.body.guideJaw(0);
  for (int k = 0; k < 20; ++k) cutting.body.step();
  const BodyCounts before = cutting.body.counts();
  const auto opening = [&] { return cutting.body.motion().max_displacement; };
  const double at_first = opening();
  StepResult last;
  for (int k = 1; k <= 20; ++k) {
    cutting.body.guideJaw(0.002 * k);
    last = cutting.body.step();
  }
  EXPECT_EQ(cutting.body.counts().parts, before.parts);
  EXPECT_GT(opening(), at_first);
  EXPECT_LT(last.tools[0].jaw_torque, 0);
}

TEST(Scissors, SwitchedOffCutNothing) {
  Cutting cutting(strip(1e6));
  cutting.body.activateTool(false);
  cutting.closeTo(0);
  EXPECT_EQ(cutting.body.counts().cracks, 0);
}

TEST(Scissors, WithoutABoxOnEachBladeAreRefused) {
  Scene scene = strip(1e6);
  std::string round = urdf();
  const std::string box = "<box size='0.1 0.002 0.006'/>";
  round.replace(round.find(box), box.size(), "<sphere radius='0.01'/>");
  EXPECT_THROW(DeformableBody(scene, loadMesh(scene), {{round}, ""}), InputError);
}

}  // namespace
}  // namespace incision
