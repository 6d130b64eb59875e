#include "incision/surface/gaps.h"

#include <gtest/gtest.h>

namespace incision {
namespace {

std::vector<SurfaceEdge> sides(const std::vector<std::vector<int>>& polygons) {
  std::vector<SurfaceEdge> edges;
  for (std::size_t p = 0; p < polygons.size(); ++p)
    for (std::size_t i = 0; i < polygons[p].size(); ++i)
      edges.push_back({polygons[p][i], polygons[p][(i + 1) % polygons[p].size()], static_cast<int>(p)});
  return edges;
}

TEST(Gaps, AreNoneInAClosedSurface) {
  EXPECT_TRUE(findGaps(sides({{0, 1, 2}, {0, 3, 1}, {1, 3, 2}, {2, 3, 0}}), 4).empty());
}

TEST(Gaps, AreNoneWhereFourPolygonsMeetAtAnEdge) {
  EXPECT_TRUE(findGaps(sides({{0, 1, 2}, {2, 1, 0}, {0, 1, 3}, {3, 1, 0}}), 4).empty());
}

TEST(Gaps, AreTheSidesOfAMissingPolygon) {
  const auto gaps = findGaps(sides({{0, 1, 2}, {0, 3, 1}, {1, 3, 2}}), 4);
  ASSERT_EQ(gaps.size(), 1u);
  ASSERT_EQ(gaps[0].size(), 3u);
  for (std::size_t i = 0; i < 3; ++i) EXPECT_EQ(gaps[0][i].to, gaps[0][(i + 1) % 3].from);
}

TEST(Gaps, ThatTouchAtAVertexComeApart) {
  const auto gaps = findGaps(sides({{0, 1, 2}, {0, 3, 4}}), 5);
  ASSERT_EQ(gaps.size(), 2u);
  for (const auto& gap : gaps) EXPECT_EQ(gap.size(), 3u);
}

}  // namespace
}  // namespace incision
