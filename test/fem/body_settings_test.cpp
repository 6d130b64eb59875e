#include "incision/fem/body_settings.h"

#include <gtest/gtest.h>

#include "support/section.h"

namespace incision {
namespace {

TEST(BodySettings, ArriveFromTheirSection) {
  const BodySettings body = parseBody(test::section(
      "body",
      "{mesh: a.msh, frame: liver, material: {density: 2}, pressure: averaged, warping: false, mass: consistent}"));
  ASSERT_EQ(body.meshes.size(), 1u);
  EXPECT_EQ(body.meshes[0].file, "/folder/a.msh");
  EXPECT_FALSE(body.grid);
  EXPECT_EQ(body.frame, "liver");
  EXPECT_EQ(body.material.density, 2);
  EXPECT_EQ(body.pressure, Pressure::AVERAGED);
  EXPECT_FALSE(body.warping);
  EXPECT_EQ(body.mass, Mass::CONSISTENT);
}

TEST(BodySettings, BadValuesAreRefused) {
  const auto withGrid = [](const std::string& entry) { return "{grid: {cells: [1, 1, 1]}, " + entry + "}"; };
  test::expectRefused(parseBody, "body",
                      {{"{}", ": needs a mesh, meshes or a grid (allowed: one of the three)"},
                       {"{mesh: a.msh, meshes: {a: {file: a.msh}}}", ": needs a mesh, meshes or a grid"},
                       {withGrid("mesh: a.msh"), ": needs a mesh, meshes or a grid"},
                       {"{mesh: ''}", ".mesh"},
                       {"{grid: {cells: [0, 1, 1]}}", ".grid.cells.0"},
                       {withGrid("frame: /body"), ".frame"},
                       {withGrid("warping: maybe"), ".warping: 'maybe' (allowed: true, false)"},
                       {withGrid("mass: heavy"), ".mass: 'heavy' (allowed: consistent, lumped)"},
                       {withGrid("pressure: high"), ".pressure: 'high' (allowed: averaged, element)"},
                       {withGrid("material: {density: 1, density: 2}"), ".material.density: given twice"}});
}

}  // namespace
}  // namespace incision
