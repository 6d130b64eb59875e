#include <gtest/gtest.h>

#include "incision/rigid/box.h"
#include "incision/ros/markers.h"

namespace incision {
namespace {

using visualization_msgs::Marker;

constexpr double ROUNDING = 1e-14;  // of coordinates below 10
const Edge EDGE = {Vec3::Zero(), Vec3(0, 0, 0.06)};

/// The shapes of a tool with one box.
Obstacles tool() {
  Obstacles shapes;
  shapes.links = {{"blade", Pose()}};
  Pose middle;
  middle.position.z() = 0.03;
  shapes.shapes = {{std::make_shared<Box>(Vec3(0.01, 0.001, 0.06)), middle, 0}};
  return shapes;
}

visualization_msgs::MarkerArray draw(const ToolView& view) {
  return toMarkers(tool(), EDGE, view, "body", ros::Time());
}

TEST(ToolMarkers, EdgeShapesAndForceStandWhereTheToolIs) {
  ToolView view;
  view.pose = Pose{Vec3(1, 2, 3), Eigen::Quaterniond(Eigen::AngleAxisd(M_PI / 2, Vec3::UnitY()))};  // z to x
  view.force = Vec3(0, 0, 5);
  const auto array = draw(view);
  ASSERT_EQ(3u, array.markers.size());
  EXPECT_EQ(Marker::LINE_LIST, array.markers[0].type);
  EXPECT_NEAR(1.06, array.markers[0].points.at(1).x, ROUNDING);
  EXPECT_EQ(Marker::ARROW, array.markers[1].type);
  EXPECT_EQ(Marker::ADD, array.markers[1].action);
  EXPECT_NEAR(1 + 5 * FORCE_SCALE, array.markers[1].points.at(1).x, ROUNDING);
  EXPECT_NEAR(3, array.markers[1].points.at(1).z, ROUNDING);
  EXPECT_EQ(Marker::CUBE, array.markers[2].type);
  EXPECT_NEAR(1.03, array.markers[2].pose.position.x, ROUNDING);
}

TEST(ToolMarkers, NoForceIsNoArrow) { EXPECT_EQ(Marker::DELETE, draw({Pose()}).markers[1].action); }

TEST(ToolMarkers, AToolThatIsGoneIsDeleted) {
  const auto array = draw({});
  ASSERT_EQ(1u, array.markers.size());
  EXPECT_EQ(Marker::DELETEALL, array.markers[0].action);
}

}  // namespace
}  // namespace incision
