#include "incision/tool/blade/blade_edge.h"

#include <gtest/gtest.h>

#include <cmath>
#include <fstream>
#include <limits>
#include <sstream>

#include "incision/base/input_error.h"
#include "support/tool.h"

namespace incision {
namespace {

constexpr double ROUNDING = 1e-15;  // of coordinates below 1

// A description whose link `blade` has the given collisions.
std::string described(const std::string& collisions) {
  return "<robot name=\"r\"><link name=\"blade\">" + collisions + "</link></robot>";
}

std::string box(const std::string& size, const std::string& origin = "") {
  return "<collision>" + origin + "<geometry><box size=\"" + size + "\"/></geometry></collision>";
}

Edge edgeOf(const std::string& urdf, const std::string& link = "blade") {
  ToolSettings tool;
  tool.link = link;
  return bladeEdge(tool, parseDescription(urdf, "tool.urdf"));
}

// What is said of a description, and what urdfdom printed; the former empty when it is accepted.
struct Said {
  std::string message, printed;
};
Said said(const std::string& urdf, const std::string& link = "blade") {
  ::testing::internal::CaptureStderr();
  Said said;
  try {
    edgeOf(urdf, link);
  } catch (const InputError& error) {
    said.message = error.what();
  }
  said.printed = ::testing::internal::GetCapturedStderr();
  return said;
}

TEST(BladeEdge, IsTheLongestEdgeWithTheSmallestOtherCoordinates) {
  const Edge edge = edgeOf(described(box("0.01 0.1 0.002")));
  EXPECT_LT((edge[0] - Vec3(-0.005, -0.05, -0.001)).norm(), ROUNDING);
  EXPECT_LT((edge[1] - Vec3(-0.005, 0.05, -0.001)).norm(), ROUNDING);
}

TEST(BladeEdge, FollowsTheCollisionsOrigin) {
  const double quarter = std::acos(0.0);
  std::ostringstream origin;
  origin.precision(17);
  origin << "<origin xyz=\"1 2 3\" rpy=\"0 0 " << quarter << "\"/>";
  const Edge edge = edgeOf(described(box("0.2 0.04 0.02", origin.str())));
  // A quarter turn round z takes (x, y) to (−y, x).
  EXPECT_LT((edge[0] - Vec3(1.02, 1.9, 2.99)).norm(), 4 * ROUNDING);
  EXPECT_LT((edge[1] - Vec3(1.02, 2.1, 2.99)).norm(), 4 * ROUNDING);
}

TEST(BladeEdge, ComesFromTheFirstBox) {
  const std::string sphere = "<collision><geometry><sphere radius=\"1\"/></geometry></collision>";
  const Edge edge = edgeOf(described(sphere + box("1 2 1") + box("1 8 1")));
  EXPECT_NEAR((edge[1] - edge[0]).norm(), 2, ROUNDING);
}

TEST(BladeEdge, GivenEdgeNeedsNoDescription) {
  ToolSettings tool;
  bladeOf(&tool).edge = {Vec3(0, 0, 0), Vec3(0, 0, 0.1)};
  EXPECT_EQ(bladeEdge(tool, {"tool", {}}), *bladeOf(&tool).edge);
}

TEST(BladeEdge, GivenEdgeMustHaveTwoFiniteEnds) {
  ToolSettings tool;
  bladeOf(&tool).edge = {Vec3(1, 2, 3), Vec3(1, 2, 3)};
  EXPECT_THROW(bladeEdge(tool, {"tool", {}}), InputError);
  bladeOf(&tool).edge = {Vec3(0, 0, 0), Vec3(0, 0, std::numeric_limits<double>::quiet_NaN())};
  EXPECT_THROW(bladeEdge(tool, {"tool", {}}), InputError);
}

TEST(BladeEdge, SampleScalpelCutsAlongItsLinksAxis) {
  std::ifstream file(INCISION_SOURCE_DIR "/config/scalpel.urdf");
  std::stringstream urdf;
  urdf << file.rdbuf();
  const Edge edge = edgeOf(urdf.str());
  EXPECT_LT(edge[0].norm(), ROUNDING);
  EXPECT_LT((edge[1] - Vec3(0, 0, 0.06)).norm(), ROUNDING);
}

class RefusedDescription : public ::testing::TestWithParam<std::string> {};

TEST_P(RefusedDescription, IsNamedInOneLineAndNothingElseIsPrinted) {
  const Said said = incision::said(GetParam());
  EXPECT_EQ(said.message.find("tool.urdf: "), 0u) << said.message;
  EXPECT_EQ(said.message.find('\n'), std::string::npos) << said.message;
  EXPECT_EQ(said.printed, "");
}

INSTANTIATE_TEST_SUITE_P(
    BladeEdge, RefusedDescription,
    ::testing::Values("", "no xml at all", "<robot", "<robot name=\"r\"/>", "<world name=\"w\"/>", described(""),
                      "<robot name=\"r\"><link name=\"handle\">" + box("1 1 1") + "</link></robot>",
                      described("<collision><geometry><sphere radius=\"1\"/></geometry></collision>"),
                      described(box("0 1 1")), described(box("-1 1 1")), described(box("nan 1 1")),
                      described(box("inf 1 1")), described(box("1e999 1 1")), described(box("1 1")),
                      described(box("a b c")), described(box("1 1 1", "<origin xyz=\"nan 0 0\"/>")),
                      described(box("1 1 1", "<origin xyz=\"0 0 0\" rpy=\"inf 0 0\"/>")),
                      described(box("1.7e308 1 1", "<origin xyz=\"1.7e308 0 0\"/>")),
                      std::string((std::size_t{1} << 20) + 1, ' ')));

TEST(BladeEdge, DeepNestingDoesNotExhaustTheStack) {
  std::string nested;
  for (int i = 0; i < 300'000; ++i) nested += "<a>";
  EXPECT_NE(said("<robot name=\"r\">" + nested).message.find("elements"), std::string::npos);
}

// What the sanitizer watches: the parser must not read past the end.
TEST(BladeEdge, TextThatBreaksOffWithinACharacterIsRefused) {
  EXPECT_NE(said("<robot name=\"r\"><link \xf1").message, "");
}

TEST(BladeEdge, FormatsInTheTextAreNotPrinted) {
  for (const char* name : {"%n%n%n%n", "&#37;n&#37;n&#37;n&#37;n"}) {
    const std::string visual = std::string("<visual><origin xyz=\"") + name + " 0 0\"/></visual>";
    EXPECT_NE(said("<robot name=\"r\"><link name=\"blade\">" + visual + "</link></robot>").message, "");
  }
}

TEST(BladeEdge, CarriedToAPoseItIsTurnedThenMoved) {
  const double s = std::sqrt(0.5);
  const Pose pose = {Vec3(1, 2, 3), Eigen::Quaterniond(s, 0, 0, s)};  // a quarter turn round z
  const Edge edge = placed(Edge{Vec3(0, 0, 0), Vec3(1, 0, 0)}, pose);
  EXPECT_EQ(edge[0], Vec3(1, 2, 3));
  EXPECT_LT((edge[1] - Vec3(1, 3, 3)).norm(), 4 * ROUNDING);
}

}  // namespace
}  // namespace incision
