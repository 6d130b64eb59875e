#include <gtest/gtest.h>

#include <cmath>
#include <memory>

#include "incision/rigid/capsule.h"
#include "incision/rigid/mesh_solid.h"
#include "incision/ros/markers.h"
#include "support/mesh_folder.h"
#include "support/solid_meshes.h"

namespace incision::test {
namespace {

using visualization_msgs::Marker;

Marker markerOf(SolidPtr solid) {
  Obstacles obstacles;
  obstacles.links.push_back({"thing", {}});
  obstacles.shapes.push_back({std::move(solid), {}, 0});
  return toMarkers(obstacles, {Pose()}, "body", ros::Time(1)).markers.at(0);
}

Vec3 toVec3(const geometry_msgs::Point& point) { return {point.x, point.y, point.z}; }

TEST(SolidMarkers, AMeshInAFileIsTheFileStretched) {
  const MeshFolder folder("markers");
  const std::string shape = folder.shape("box.stl", asBinaryStl(boxMesh(Vec3(1, 2, 3))), "1 -2 0.5");
  const std::string urdf =
      "<robot name='r'><link name='a'><collision><geometry>" + shape + "</geometry></collision></link></robot>";
  const Obstacles obstacles = loadLink(parseDescription(urdf, "room.urdf"), "a");
  const Marker marker = markerOf(obstacles.shapes.at(0).solid);
  EXPECT_EQ(marker.type, Marker::MESH_RESOURCE);
  EXPECT_EQ(marker.mesh_resource, "file://" + folder.at("box.stl"));
  EXPECT_EQ(marker.scale.y, -2);
  EXPECT_FALSE(marker.mesh_use_embedded_materials);
  EXPECT_TRUE(marker.points.empty());
}

TEST(SolidMarkers, AMeshWithoutAFileIsItsTriangles) {
  std::string remark;
  const Marker marker = markerOf(std::make_shared<MeshSolid>(closeMesh(boxMesh(Vec3(1, 2, 3)), &remark)));
  EXPECT_EQ(marker.type, Marker::TRIANGLE_LIST);
  ASSERT_EQ(marker.points.size(), 36u);
  EXPECT_EQ(marker.scale.x, 1);
  EXPECT_LT((toVec3(marker.points[0]).cwiseAbs() - Vec3(0.5, 1, 1.5)).norm(), 1e-12);
}

TEST(SolidMarkers, ACapsuleIsDrawnOnItsSurfaceAndLooksOutwards) {
  const Capsule capsule(0.2, 0.6);
  const Marker marker = markerOf(std::make_shared<Capsule>(0.2, 0.6));
  EXPECT_EQ(marker.type, Marker::TRIANGLE_LIST);
  EXPECT_EQ(marker.scale.x, 1);
  ASSERT_GT(marker.points.size(), 0u);
  ASSERT_EQ(marker.points.size() % 3, 0u);
  double volume = 0;
  for (std::size_t i = 0; i < marker.points.size(); i += 3) {
    const Vec3 a = toVec3(marker.points[i]), b = toVec3(marker.points[i + 1]), c = toVec3(marker.points[i + 2]);
    for (const Vec3& corner : {a, b, c}) EXPECT_NEAR(capsule.distanceTo(corner).distance, 0, 1e-12);
    volume += a.dot(b.cross(c)) / 6;
  }
  const double exact = M_PI * 0.2 * 0.2 * (0.6 + 4.0 / 3 * 0.2);
  EXPECT_NEAR(volume, exact, 0.03 * exact);
}

}  // namespace
}  // namespace incision::test
