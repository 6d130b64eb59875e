#include "incision/cut/settings.h"

#include <gtest/gtest.h>

#include "support/section.h"

namespace incision {
namespace {

TEST(ScheduledCut, ArrivesFromItsSection) {
  const ScheduledCut cut = parseCut(
      test::section("cuts.0",
                    "{time: 0.25, label: first, point: [0.5, 0, 0], normal: [1, 0, 0], tangent: [0, 1, 0], length: 2, "
                    "width: 3}"));
  EXPECT_EQ(cut.time, 0.25);
  EXPECT_EQ(cut.plane.label, "first");
  EXPECT_EQ(cut.plane.point, Vec3(0.5, 0, 0));
  EXPECT_EQ(cut.plane.normal, Vec3(1, 0, 0));
  EXPECT_EQ(cut.plane.tangent, Vec3(0, 1, 0));
  EXPECT_EQ(cut.plane.length, 2);
  EXPECT_EQ(cut.plane.width, 3);
}

TEST(ScheduledCut, LongestAllowedLabelIsKept) {
  const std::string label(MAX_LABEL, 'x');
  EXPECT_EQ(parseCut(test::section("cuts.0", "{normal: [1, 0, 0], label: " + label + "}")).plane.label, label);
}

TEST(ScheduledCut, BadValuesAreRefused) {
  const auto across = [](const std::string& entry) { return "{normal: [1, 0, 0], " + entry + "}"; };
  test::expectRefused(parseCut, "cuts.0",
                      {{"{point: [0, 0, 0]}", ": the key normal is missing"},
                       {"{normal: [0, 0, 0]}", ": normal: zero"},
                       {across("time: -1"), ".time"},
                       {across("time: 1e300"), ".time"},
                       {across("label: " + std::string(MAX_LABEL + 1, 'x')), ".label"},
                       {across("label: \"a\\nb\""), ".label"},
                       {across("length: -1"), ".length"},
                       {across("width: .inf"), ".width"},
                       {across("length: 1, tangent: [2, 0, 0]"), ": tangent"}});
}

}  // namespace
}  // namespace incision
