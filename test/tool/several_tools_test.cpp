// Laws of several tools that act at once.
#include <gtest/gtest.h>
#include <yaml-cpp/yaml.h>

#include <algorithm>
#include <cmath>

#include "support/blade.h"
#include "support/forceps.h"
#include "support/tool.h"

namespace incision {
namespace {

constexpr double THROUGH = 0.06;  // how far before and behind the plate a blade goes [m]

/// Of the plate's blade, with a name and a cutting force.
ToolSettings named(ToolSettings tool, const std::string& name, double cutting_force = 0) {
  tool.name = name;
  bladeOf(&tool).cutting.resistance.force = cutting_force;
  return tool;
}

/// The plate with blades of these names, held at its far right.
Scene plateAndBlades(const std::vector<std::string>& names, double cutting_force = 0) {
  Scene scene = plateAndBlade();
  const ToolSettings blade = scene.tools[0];
  scene.tools.clear();
  for (const std::string& name : names) scene.tools.push_back(named(blade, name, cutting_force));
  return scene;
}

Pose alongY(double x, double share) { return poseAt(x, -THROUGH + share * (0.5 + 2 * THROUGH)); }
Pose alongX(double y, double share) { return poseAt(-THROUGH + share * (1 + 2 * THROUGH), y); }

/// Leads all tools, one pose a step each; the strokes that ended.
template <class PoseOf>
std::vector<CutResult> lead(DeformableBody* body, int steps, const PoseOf& pose_of) {
  std::vector<CutResult> ended;
  for (int k = 0; k <= steps; ++k) {
    for (std::size_t tool = 0; tool < body->tools(); ++tool)
      body->guideTool({pose_of(tool, static_cast<double>(k) / steps)}, tool);
    for (const CutResult& cut : body->step().cuts) ended.push_back(cut);
  }
  return ended;
}

TEST(SeveralTools, CutAtOnceAndEachReportsItsOwn) {
  const Scene scene = plateAndBlades({"left", "right"});
  DeformableBody body(scene, loadMesh(scene));
  const auto ended =
      lead(&body, 40, [](std::size_t tool, double share) { return alongY(tool == 0 ? 0.31 : 0.67, share); });
  EXPECT_EQ(body.counts().pieces, 3);
  ASSERT_EQ(ended.size(), 2u);
  EXPECT_EQ(ended[0].label, "left");
  EXPECT_EQ(ended[1].label, "right");
  for (const CutResult& cut : ended) EXPECT_EQ(cut.status, CutStatus::APPLIED) << cut.reason;
  const std::vector<double> volumes = body.pieceVolumes();
  EXPECT_NEAR(volumes[0], 0.31 * 0.125, 1e-3);
  EXPECT_NEAR(volumes[1], 0.33 * 0.125, 1e-3);
}

// They meet in the middle at the same time: each goes on through what the other has cut.
TEST(SeveralTools, StrokesThatCrossPartThePlateInFour) {
  for (double offset : {0.0, 0.013, 0.031}) {
    const Scene scene = plateAndBlades({"along", "across"});
    DeformableBody body(scene, loadMesh(scene));
    lead(&body, 50, [&](std::size_t tool, double share) {
      return tool == 0 ? alongX(0.26 + offset, share) : alongY(0.52 + offset, share);
    });
    EXPECT_EQ(body.counts().pieces, 4) << offset;
  }
}

TEST(SeveralTools, ABladeBehindAnotherInItsSlitCutsAndFeelsNothing) {
  const double force = 20;
  const Scene scene = [&] {
    Scene held = plateAndBlades({"first", "second"}, force);
    held.boundary = {{Place(Vec3(-1, -1, -1), Vec3(0.2, 1, 1)), Vec3::Zero()},
                     {Place(Vec3(0.8, -1, -1), Vec3(2, 1, 1)), Vec3::Zero()}};
    return held;
  }();
  DeformableBody body(scene, loadMesh(scene));
  double felt = 0;
  for (int k = 0; k <= 60; ++k) {
    body.guideTool({alongY(0.49, k / 60.0)}, 0);
    body.guideTool({alongY(0.49, std::max(0.0, k / 60.0 - 0.25))}, 1);
    felt = std::max(felt, body.step().tools[1].force.norm());
  }
  EXPECT_EQ(body.counts().pieces, 2);
  EXPECT_EQ(body.counts().cracks, 1);
  EXPECT_LT(felt, 0.02 * force * 0.25);
}

/// From both sides, into the same plane; one goes on to where the other stopped, and beyond.
TEST(SeveralTools, WhatOneHasLeftTiedTheOtherFrees) {
  const Scene scene = plateAndBlades({"front", "rear"});
  DeformableBody body(scene, loadMesh(scene));
  lead(&body, 30, [](std::size_t tool, double share) {
    return tool == 0 ? alongY(0.49, 0.45 * share) : alongY(0.49, 1 - 0.2 * share);
  });
  EXPECT_EQ(body.counts().pieces, 1);
  lead(&body, 30,
       [](std::size_t tool, double share) { return tool == 0 ? alongY(0.49, 0.45) : alongY(0.49, 0.8 - 0.5 * share); });
  EXPECT_EQ(body.counts().pieces, 2);
}

/// The plate's two blades by their sections in a file.
std::uint64_t hashOf(const std::string& tools) {
  Scene scene = parseScene(YAML::Load("body: {grid: {cells: [8, 4, 2], size: [1, 0.5, 0.25]}, material: "
                                      "{young_modulus: 1e5}}\ngravity: [0, 0, 0]\ntools: {" +
                                      tools + "}"),
                           "scene.yaml", "/folder");
  DeformableBody body(scene, loadMesh(scene));
  for (int k = 0; k < 30; ++k) body.step();
  EXPECT_GT(body.counts().cracks, 1);
  return body.stateHash();
}

TEST(SeveralTools, TheirOrderInTheFileDoesNotMatter) {
  const std::string blade = "{type: blade, cutting_force: 20, edge: [[0, 0, -0.1], [0, 0, 0.35]], poses: ";
  const std::string first = "first: " + blade + "[[0, 0.3, -0.1, 0, 0, 0, 0, 1], [0.3, 0.3, 0.4, 0, 0, 0, 0, 1]]}";
  const std::string second = "second: " + blade + "[[0, 0.7, 0.6, 0, 0, 0, 0, 1], [0.3, 0.7, 0.2, 0, 0, 0, 0, 1]]}";
  EXPECT_EQ(hashOf(first + ", " + second), hashOf(second + ", " + first));
}

/// The change of momentum is what all tools have felt, the other way round.
TEST(SeveralTools, TheirForcesSumToTheChangeOfMomentum) {
  Scene scene = plateAndBlades({"left", "right"}, 50);
  scene.solver.time_step = 0.005;
  ToolSettings probe = bladeTool(std::nullopt, "probe.urdf");
  probe.name = "probe";
  probe.kind = ProbeSettings();
  scene.tools.push_back(probe);
  scene.contact.emplace();
  const std::string ball =
      "<robot name='p'><link name='blade'><collision><geometry><sphere radius='0.05'/></geometry></collision></link>"
      "</robot>";
  DeformableBody body(scene, loadMesh(scene), {{"", "", ball}, ""});
  double largest = 0;
  int all_push = 0;
  for (int k = 0; k <= 80; ++k) {
    const double share = k / 80.0;
    body.guideTool({alongY(0.31, share)}, 0);
    body.guideTool({alongY(0.67, share)}, 1);
    body.guideTool({poseAt(0.5, 0.25, 0.32 - 0.1 * share)}, 2);
    const Vec3 before = body.motion().momentum;
    const StepResult step = body.step();
    Vec3 sum = Vec3::Zero();
    int push = 0;
    for (const ToolReport& tool : step.tools) {
      sum += tool.force;  // the links are turned as the body's frame is
      push += tool.force.norm() > 0;
      largest = std::max(largest, tool.force.norm());
    }
    all_push += push == 3;
    const Vec3 rate = (body.motion().momentum - before) / scene.solver.time_step;
    EXPECT_LT((rate + sum).norm(), 1e-10 * std::max(1.0, largest)) << k;
  }
  EXPECT_GT(all_push, 5);
}

}  // namespace
}  // namespace incision
