#include "incision/tool/settings.h"

#include <gtest/gtest.h>

#include <cmath>

#include "support/section.h"
#include "support/tool.h"

namespace incision {
namespace {

TEST(ToolSettings, ArriveFromTheirSection) {
  const std::vector<ToolSettings> tools = parseTools(test::section(
      "tools",
      "{scalpel: {type: blade, description: a.urdf, link: blade, edge: [[0, 0, 0], [0, 0, 0.1]], poses: [[0.5, 1, 2, "
      "3, 0, 0, 0, 1]], frame: knife, max_step: 0.02, timeout: .inf, cutting_force: 40, cutting_viscosity: 2, "
      "cutting_onset: 30, friction: 0.1, progressive: "
      "false}, hook: {type: probe, description: b.urdf, link: tip}}"));
  ASSERT_EQ(tools.size(), 2u);
  EXPECT_EQ(tools[0].name, "hook");
  EXPECT_TRUE(std::holds_alternative<ProbeSettings>(tools[0].kind));
  ToolSettings tool = tools[1];
  EXPECT_EQ(tool.name, "scalpel");
  EXPECT_EQ(tool.description, "/folder/a.urdf");
  EXPECT_EQ(tool.link, "blade");
  ASSERT_TRUE(bladeOf(&tool).edge);
  EXPECT_EQ((*bladeOf(&tool).edge)[1], Vec3(0, 0, 0.1));
  EXPECT_EQ(tool.poses.size(), 1u);
  EXPECT_EQ(tool.frame, "knife");
  EXPECT_EQ(tool.max_step, 0.02);
  EXPECT_TRUE(std::isinf(tool.timeout));
  EXPECT_EQ(bladeOf(&tool).cutting.resistance.force, 40);
  EXPECT_EQ(bladeOf(&tool).cutting.resistance.viscosity, 2);
  EXPECT_EQ(bladeOf(&tool).cutting.resistance.onset, 30);
  EXPECT_EQ(tool.friction, 0.1);
  EXPECT_FALSE(bladeOf(&tool).cutting.progressive);
}

TEST(ToolSettings, OfAGrasperSayWhenAndHowItHolds) {
  const std::vector<ToolSettings> tools = parseTools(test::section(
      "tools",
      "{f: {type: grasper, description: a.urdf, link: palm, joint: jaw, closed: -0.1, grip: 5, jaw: [[0, 1], [2, "
      "-0.2]]}}"));
  ASSERT_EQ(tools.size(), 1u);
  const auto& grasper = std::get<GrasperSettings>(tools[0].kind);
  EXPECT_EQ(grasper.closed, -0.1);
  EXPECT_EQ(grasper.grip, 5);
  ASSERT_TRUE(tools[0].jaw);
  EXPECT_EQ(tools[0].jaw->joint, "jaw");
  EXPECT_EQ(tools[0].jaw->angles.size(), 2u);
}

TEST(ToolSettings, OfScissorsSayWhatCuttingTakes) {
  const std::vector<ToolSettings> tools = parseTools(test::section(
      "tools",
      "{s: {type: scissors, description: a.urdf, link: palm, joint: jaw, cutting_force: 40, cutting_viscosity: 2, "
      "cutting_onset: 30}}"));
  ASSERT_EQ(tools.size(), 1u);
  const auto& scissors = std::get<ScissorsSettings>(tools[0].kind);
  EXPECT_EQ(scissors.cutting.resistance.force, 40);
  EXPECT_EQ(scissors.cutting.resistance.viscosity, 2);
  EXPECT_EQ(scissors.cutting.resistance.onset, 30);
}

TEST(ToolSettings, BadValuesAreRefused) {
  const auto knife = [](const std::string& entry) {
    return "{knife: {type: blade, edge: [[0, 0, 0], [0, 0, 1]], " + entry + "}}";
  };
  test::expectRefused(
      parseTools, "tools",
      {{"[]", ": a list of 0 (allowed: a map of 1 to 100 names"},
       {"{}", ": a map (allowed: a map of 1 to 100 names"},
       {"{edge: [[0, 0, 0], [0, 0, 1]]}", ".edge: the key type is missing (allowed: blade, grasper, probe"},
       {"{knife: {edge: [[0, 0, 0], [0, 0, 1]]}}", ".knife: the key type is missing"},
       {"{knife: {type: sword}}", ".knife.type: 'sword' (allowed: blade, "},
       {"{left-hand: {type: blade, edge: [[0, 0, 0], [0, 0, 1]]}}", ".left-hand: the name of a tool"},
       {"{1st: {type: blade, edge: [[0, 0, 0], [0, 0, 1]]}}", ".1st: the name of a tool"},
       {"{knife: {type: blade, link: blade, poses: []}}", ".knife: needs an edge"},
       {"{knife: {type: blade, description: a.urdf}}", ".knife: the key link is missing"},
       {"{f: {type: grasper, description: a.urdf, link: a, joint: j, grip: 1}}", ".f: the key closed is missing"},
       {"{f: {type: grasper, description: a.urdf, link: a, joint: j, closed: 0}}", ".f: the key grip is missing"},
       {"{f: {type: grasper, description: a.urdf, link: a, joint: j, closed: 0, grip: 0}}", ".f.grip"},
       {"{f: {type: grasper, description: a.urdf, link: a, joint: j, closed: .nan, grip: 1}}", ".f.closed"},
       {"{f: {type: grasper, description: a.urdf, link: a, closed: 0, grip: 1}}", ".f: the key joint is missing"},
       {"{hook: {type: probe, link: a}}", ".hook: the key description is missing"},
       {"{hook: {type: probe, description: a.urdf, link: a, edge: []}}", ".hook.edge: unknown key"},
       {"{knife: {type: blade, edge: [[0, 0, 0], [0, 0, 0]]}}", ".knife.edge: both ends are the same point"},
       {"{knife: {type: blade, edge: [[0, 0, 0]]}}", ".knife.edge"},
       {knife("poses: [[0, 0, 0, 0, 0, 0, 1]]"), ".knife.poses.0"},
       {knife("frame: /knife"), ".knife.frame"},
       {knife("max_step: 0"), ".knife.max_step"},
       {knife("timeout: -1"), ".knife.timeout"},
       {knife("cutting_force: -1"), ".knife.cutting_force"},
       {knife("cutting_force: .inf"), ".knife.cutting_force"},
       {knife("cutting_viscosity: -1"), ".knife.cutting_viscosity"},
       {knife("cutting_onset: -1"), ".knife.cutting_onset"},
       {knife("cutting_onset: .inf"), ".knife.cutting_onset"},
       {knife("friction: 11"), ".knife.friction"},
       {knife("progressive: 0.5"), ".knife.progressive"}});
}

}  // namespace
}  // namespace incision
