#include "incision/ros/body_markers.h"

#include <gtest/gtest.h>

#include <array>
#include <map>
#include <set>
#include <string>
#include <utility>

#include "incision/cut/cut_mesh.h"
#include "incision/mesh/grid_mesh.h"

namespace incision {
namespace {

using visualization_msgs::Marker;

/// A cube's surface, its triangles in turn in two regions.
struct Cube {
  explicit Cube(MarkerField field) : surface(buildSurface(mesh)) {
    view.surface = &surface;
    view.x = surfacePositions(surface, mesh.mesh().nodes);
    view.field = field;
    view.num_regions = 2;
    for (std::size_t t = 0; t < surface.triangles.size(); ++t) {
      view.regions.push_back(static_cast<int>(t % 2));
      view.von_mises.push_back(static_cast<double>(t));
    }
  }
  CutMesh mesh{gridMesh({{2, 2, 2}, Vec3::Ones(), Vec3::Zero()})};
  Surface surface;
  BodyView view;

  std::vector<Marker> draw() const { return toMarkers(view, "body", ros::Time()).markers; }
};

TEST(BodyMarkers, OfRegionsHaveOneColourEachAndNoneForEachPoint) {
  const Cube cube(MarkerField::REGION);
  const std::vector<Marker> markers = cube.draw();
  ASSERT_EQ(markers.size(), 8u);
  for (int region : {0, 1}) {
    EXPECT_EQ(markers[2 * region].action, Marker::ADD);
    EXPECT_EQ(markers[2 * region].points.size(), 3 * cube.surface.triangles.size() / 2);
    EXPECT_TRUE(markers[2 * region].colors.empty());
    EXPECT_EQ(markers[2 * region + 1].action, Marker::DELETE);
  }
  EXPECT_NE(markers[0].color.r, markers[2].color.r);
}

TEST(BodyMarkers, OfStressHaveAColourForEachPoint) {
  const Cube cube(MarkerField::STRESS);
  const std::vector<Marker> markers = cube.draw();
  const Marker& skin = markers[4];  // after those of the regions
  ASSERT_EQ(skin.points.size(), 3 * cube.surface.triangles.size());
  ASSERT_EQ(skin.colors.size(), skin.points.size());
  EXPECT_GT(skin.colors.front().b, skin.colors.front().r);  // the least
  EXPECT_GT(skin.colors.back().r, skin.colors.back().b);    // the most
  for (const auto& colour : skin.colors)
    for (float value : {colour.r, colour.g, colour.b}) EXPECT_TRUE(value >= 0 && value <= 1);
}

TEST(BodyMarkers, OfEveryFieldHaveTheSameIdsAndAListWithColoursIsNeverOneWithout) {
  std::set<std::pair<std::string, int>> ids, with, without;
  for (const MarkerField field : {MarkerField::NONE, MarkerField::REGION, MarkerField::STRESS}) {
    const std::vector<Marker> markers = Cube(field).draw();
    std::set<std::pair<std::string, int>> of_field;
    for (const Marker& marker : markers) {
      of_field.emplace(marker.ns, marker.id);
      if (marker.action == Marker::ADD) (marker.colors.empty() ? without : with).emplace(marker.ns, marker.id);
    }
    EXPECT_EQ(of_field.size(), markers.size());
    if (ids.empty()) ids = of_field;
    EXPECT_EQ(ids, of_field);
  }
  for (const auto& id : with) EXPECT_EQ(without.count(id), 0u) << id.first;
}

TEST(BodyMarkers, OfARoundedSurfaceAreFourTrianglesForEachAndClosed) {
  Cube cube(MarkerField::STRESS);
  for (Vec3& x : cube.view.x) x *= (x - Vec3::Constant(0.5)).norm();
  const Rounding rounding(cube.surface, cube.view.x);
  cube.view.rounding = &rounding;
  const std::vector<Marker> markers = cube.draw();
  const std::vector<geometry_msgs::Point>& points = markers[4].points;
  ASSERT_EQ(points.size(), 12 * cube.surface.triangles.size());
  EXPECT_EQ(markers[4].colors.size(), points.size());
  std::map<std::array<double, 6>, int> runs;  // of each side, one way less the other way
  for (std::size_t t = 0; t < points.size(); t += 3)
    for (std::size_t i = 0; i < 3; ++i) {
      const auto &a = points[t + i], &b = points[t + (i + 1) % 3];
      ++runs[{a.x, a.y, a.z, b.x, b.y, b.z}];
      --runs[{b.x, b.y, b.z, a.x, a.y, a.z}];
    }
  for (const auto& [side, balance] : runs) EXPECT_EQ(balance, 0);
}

TEST(BodyMarkers, LinesOfLoadsEndWhereTheyAct) {
  Cube cube(MarkerField::NONE);
  cube.view.element_size = 0.1;
  cube.view.loads = {{Vec3(1, 0, 0), Vec3(3, 0, 0)}, {Vec3(0, 0, 0), Vec3(0, 0, -6)}};
  cube.view.held = {Vec3::Ones()};
  const std::vector<Marker> markers = cube.draw();
  ASSERT_EQ(markers.size(), 8u);
  EXPECT_EQ(markers[6].ns, "clamps");
  EXPECT_EQ(markers[6].points.size(), 1u);
  const Marker& loads = markers[7];
  EXPECT_EQ(loads.ns, "loads");
  ASSERT_EQ(loads.points.size(), 4u);
  EXPECT_DOUBLE_EQ(loads.points[0].x, 0.9);
  EXPECT_DOUBLE_EQ(loads.points[1].x, 1);
  EXPECT_DOUBLE_EQ(loads.points[2].z, 0.2);
}

}  // namespace
}  // namespace incision
