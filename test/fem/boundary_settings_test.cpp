#include "incision/fem/boundary_settings.h"

#include <gtest/gtest.h>

#include "support/section.h"

namespace incision {
namespace {

TEST(BoundarySettings, ArriveFromTheirSections) {
  const Clamp clamp = parseClamp(test::section("boundary.0", "{box: [[-1, -2, -3], [1, 2, 3]], velocity: [4, 5, 6]}"));
  EXPECT_EQ(clamp.place.box.min, Vec3(-1, -2, -3));
  EXPECT_EQ(clamp.place.box.max, Vec3(1, 2, 3));
  EXPECT_EQ(clamp.velocity, Vec3(4, 5, 6));
  const Load load =
      parseLoad(test::section("loads.0", "{box: [[0, 0, 0], [1, 1, 1]], traction: [7, 8, 9], ramp: 0.5}"));
  EXPECT_EQ(load.place.box.max, Vec3(1, 1, 1));
  EXPECT_EQ(load.traction, Vec3(7, 8, 9));
  EXPECT_EQ(load.ramp, 0.5);
}

TEST(BoundarySettings, BadValuesAreRefused) {
  test::expectRefused(parseClamp, "boundary.0",
                      {{"{velocity: [0, 0, 0]}", ": needs a group or a box (allowed: one of the two)"},
                       {"{box: 1}", ".box: '1' (allowed: a list of 2)"},
                       {"{box: [[0, 0, 0], [1, 1]]}", ".box.1: a list of 2 (allowed: a list of 3)"},
                       {"{box: [[0, 0, 1], [1, 1, 0]]}", ".box: a lower corner above the upper"}});
  test::expectRefused(parseLoad, "loads.0",
                      {{"{box: [[0, 0, 0], [1, 1, 1]]}", ": the key traction is missing"},
                       {"{box: [[0, 0, 0], [1, 1, 1]], traction: [1, 0, 0], ramp: -1}", ".ramp"}});
}

}  // namespace
}  // namespace incision
