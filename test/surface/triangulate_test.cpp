#include "incision/surface/triangulate.h"

#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <algorithm>

namespace incision {
namespace {

Vec3 vectorAreaIn(const std::vector<Vec3>& loop, const std::array<int, 3>& t) {
  return (loop[t[1]] - loop[t[0]]).cross(loop[t[2]] - loop[t[0]]) / 2;
}

/// A triangle of area 1/2 with `points` more corners on each of its sides.
std::vector<Vec3> triangleWithPointsOnItsSides(const std::array<int, 3>& points) {
  const std::array<Vec3, 3> corners = {Vec3(0, 0, 0), Vec3(1, 0, 0), Vec3(0, 1, 0)};
  std::vector<Vec3> loop;
  for (int side = 0; side < 3; ++side)
    for (int i = 0; i <= points[side]; ++i)
      loop.push_back(corners[side] + i / (points[side] + 1.0) * (corners[(side + 1) % 3] - corners[side]));
  return loop;
}

TEST(Triangulate, FindsTrianglesOfAreaThoughCornersLieOnStraightSides) {
  for (const std::array<int, 3>& points : std::vector<std::array<int, 3>>{{0, 0, 0},
                                                                          {1, 0, 0},
                                                                          {3, 0, 0},
                                                                          {1, 1, 0},
                                                                          {1, 1, 1},
                                                                          {2, 2, 2},
                                                                          {5, 3, 4},
                                                                          {0, 7, 1},
                                                                          {40, 40, 40},
                                                                          {100, 0, 0},
                                                                          {0, 200, 1}}) {
    const std::vector<Vec3> loop = triangleWithPointsOnItsSides(points);
    const auto triangles = triangulate(loop);
    EXPECT_EQ(triangles.size(), loop.size() - 2);
    double area = 0;
    for (const auto& t : triangles) {
      EXPECT_GT(vectorAreaIn(loop, t).z(), 1e-6);
      area += vectorAreaIn(loop, t).z();
    }
    EXPECT_NEAR(area, 0.5, 1e-14);
  }
}

TEST(Triangulate, DividesAQuadrilateralAlongItsShortDiagonal) {
  const auto triangles = triangulate({Vec3(0, 0, 0), Vec3(5, -1, 0), Vec3(10, 0, 0), Vec3(5, 1, 0)});
  ASSERT_EQ(triangles.size(), 2u);
  for (const auto& t : triangles) {
    EXPECT_TRUE(std::count(t.begin(), t.end(), 1));
    EXPECT_TRUE(std::count(t.begin(), t.end(), 3));
  }
}

TEST(Triangulate, CoversAFlatPolygonToo) {
  EXPECT_EQ(triangulate({Vec3(0, 0, 0), Vec3(1, 0, 0), Vec3(2, 0, 0), Vec3(3, 0, 0)}).size(), 2u);
  EXPECT_EQ(triangulate(std::vector<Vec3>(5, Vec3::Zero())).size(), 3u);
}

}  // namespace
}  // namespace incision
