#include <gtest/gtest.h>

#include <algorithm>

#include "incision/rigid/box.h"
#include "incision/ros/markers.h"

namespace incision {
namespace {

using visualization_msgs::Marker;

constexpr double ROUNDING = 1e-14;  // of coordinates below 10

/// A tool with one box and an edge on its link, and another box on a jaw.
ToolForm tool() {
  ToolForm form;
  form.groups = 2;
  Pose middle;
  middle.position.z() = 0.03;
  form.shapes.shapes = {{std::make_shared<Box>(Vec3(0.01, 0.001, 0.06)), middle, 0},
                        {std::make_shared<Box>(Vec3(0.01, 0.001, 0.06)), middle, 1}};
  form.edges = {{0, {Vec3::Zero(), Vec3(0, 0, 0.06)}}};
  return form;
}

const ToolScale SCALE = {0.2, 0.02};

std::vector<Marker> draw(const ToolView& view) {
  return toMarkers({tool()}, {view}, SCALE, "body", ros::Time()).markers;
}

const Marker& find(const std::vector<Marker>& markers, const std::string& name, int id = 0) {
  const auto found = std::find_if(markers.begin(), markers.end(),
                                  [&](const Marker& marker) { return marker.ns == name && marker.id == id; });
  EXPECT_NE(found, markers.end());
  return *found;
}

/// z of the link points along the body's x; the jaw is 1 m farther along y.
ToolView turned() {
  ToolView view;
  view.name = "knife";
  view.groups = {Pose{Vec3(1, 2, 3), Eigen::Quaterniond(Eigen::AngleAxisd(M_PI / 2, Vec3::UnitY()))}};
  view.groups.push_back(view.groups[0]);
  view.groups[1].position.y() = 3;
  view.force = Vec3(0, 0, 5);
  return view;
}

TEST(ToolMarkers, EdgesShapesAndForceStandWhereTheToolIs) {
  const auto markers = draw(turned());
  ASSERT_EQ(5u, markers.size());
  const Marker& edge = find(markers, "knife/edge");
  EXPECT_EQ(Marker::LINE_LIST, edge.type);
  EXPECT_NEAR(1.06, edge.points.at(1).x, ROUNDING);
  const Marker& force = find(markers, "knife/force");
  EXPECT_EQ(Marker::ARROW, force.type);
  EXPECT_EQ(Marker::ADD, force.action);
  EXPECT_NEAR(1 + 5 * SCALE.force, force.points.at(1).x, ROUNDING);
  EXPECT_NEAR(3, force.points.at(1).z, ROUNDING);
  EXPECT_EQ("5 N", find(markers, "knife/force in N").text);
  for (int shape = 0; shape < 2; ++shape) {
    EXPECT_EQ(Marker::CUBE, find(markers, "knife/shape", shape).type);
    EXPECT_NEAR(1.03, find(markers, "knife/shape", shape).pose.position.x, ROUNDING);
    EXPECT_NEAR(2 + shape, find(markers, "knife/shape", shape).pose.position.y, ROUNDING);
  }
}

TEST(ToolMarkers, NoForceIsNoArrow) {
  ToolView view = turned();
  view.force.setZero();
  EXPECT_EQ(Marker::DELETE, find(draw(view), "knife/force").action);
  EXPECT_EQ(Marker::DELETE, find(draw(view), "knife/force in N").action);
}

TEST(ToolMarkers, AToolThatIsGoneIsDeletedAndNoOther) {
  ToolView gone = turned(), there = turned();
  gone.groups.clear();
  there.name = "hook";
  for (const Marker& marker : toMarkers({tool(), tool()}, {gone, there}, SCALE, "body", ros::Time()).markers)
    EXPECT_EQ(marker.ns.find("knife/") == 0 ? Marker::DELETE : Marker::ADD, marker.action) << marker.ns;
}

}  // namespace
}  // namespace incision
