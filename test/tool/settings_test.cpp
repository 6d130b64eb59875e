#include "incision/tool/settings.h"

#include <gtest/gtest.h>

#include <cmath>

#include "support/section.h"

namespace incision {
namespace {

TEST(ToolSettings, ArriveFromTheirSection) {
  const ToolSettings tool = parseTool(test::section(
      "tool",
      "{description: a.urdf, link: blade, edge: [[0, 0, 0], [0, 0, 0.1]], poses: [[0.5, 1, 2, 3, 0, 0, 0, 1]], frame: "
      "knife, max_step: 0.02, timeout: .inf, cutting_force: 40, friction: 0.1, progressive: false}"));
  EXPECT_EQ(tool.description, "/folder/a.urdf");
  EXPECT_EQ(tool.link, "blade");
  ASSERT_TRUE(tool.edge);
  EXPECT_EQ((*tool.edge)[1], Vec3(0, 0, 0.1));
  EXPECT_EQ(tool.poses.size(), 1u);
  EXPECT_EQ(tool.frame, "knife");
  EXPECT_EQ(tool.max_step, 0.02);
  EXPECT_TRUE(std::isinf(tool.timeout));
  EXPECT_EQ(tool.cutting_force, 40);
  EXPECT_EQ(tool.friction, 0.1);
  EXPECT_FALSE(tool.progressive);
}

TEST(ToolSettings, BadValuesAreRefused) {
  const auto knife = [](const std::string& entry) { return "{edge: [[0, 0, 0], [0, 0, 1]], " + entry + "}"; };
  test::expectRefused(parseTool, "tool",
                      {{"{link: blade, poses: []}", ": needs an edge"},
                       {"{description: a.urdf}", ": the key link is missing"},
                       {"{edge: [[0, 0, 0], [0, 0, 0]]}", ".edge: both ends are the same point"},
                       {"{edge: [[0, 0, 0]]}", ".edge"},
                       {knife("poses: [[0, 0, 0, 0, 0, 0, 1]]"), ".poses.0"},
                       {knife("frame: /knife"), ".frame"},
                       {knife("max_step: 0"), ".max_step"},
                       {knife("timeout: -1"), ".timeout"},
                       {knife("cutting_force: -1"), ".cutting_force"},
                       {knife("cutting_force: .inf"), ".cutting_force"},
                       {knife("friction: 11"), ".friction"},
                       {knife("progressive: 0.5"), ".progressive"}});
}

}  // namespace
}  // namespace incision
