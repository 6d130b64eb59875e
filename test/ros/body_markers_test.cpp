#include "incision/ros/body_markers.h"

#include <gtest/gtest.h>

#include <array>
#include <map>

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
  ASSERT_EQ(markers.size(), 6u);
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
  ASSERT_EQ(markers[0].colors.size(), markers[0].points.size());
  EXPECT_GT(markers[0].colors.front().b, markers[0].colors.front().r);  // the least
  EXPECT_GT(markers[0].colors.back().r, markers[0].colors.back().b);    // the most
  for (const auto& colour : markers[0].colors)
    for (float value : {colour.r, colour.g, colour.b}) EXPECT_TRUE(value >= 0 && value <= 1);
}

TEST(BodyMarkers, OfARoundedSurfaceAreFourTrianglesForEachAndClosed) {
  Cube cube(MarkerField::STRESS);
  for (Vec3& x : cube.view.x) x *= (x - Vec3::Constant(0.5)).norm();
  const Rounding rounding(cube.surface, cube.view.x);
  cube.view.rounding = &rounding;
  const std::vector<Marker> markers = cube.draw();
  ASSERT_EQ(markers[0].points.size(), 12 * cube.surface.triangles.size());
  EXPECT_EQ(markers[0].colors.size(), markers[0].points.size());
  std::map<std::array<double, 6>, int> runs;  // of each side, one way less the other way
  for (std::size_t t = 0; t < markers[0].points.size(); t += 3)
    for (std::size_t i = 0; i < 3; ++i) {
      const auto &a = markers[0].points[t + i], &b = markers[0].points[t + (i + 1) % 3];
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
  ASSERT_EQ(markers.size(), 4u);
  EXPECT_EQ(markers[2].ns, "clamps");
  EXPECT_EQ(markers[2].points.size(), 1u);
  EXPECT_EQ(markers[3].ns, "loads");
  ASSERT_EQ(markers[3].points.size(), 4u);
  EXPECT_DOUBLE_EQ(markers[3].points[0].x, 0.9);
  EXPECT_DOUBLE_EQ(markers[3].points[1].x, 1);
  EXPECT_DOUBLE_EQ(markers[3].points[2].z, 0.2);
}

}  // namespace
}  // namespace incision
