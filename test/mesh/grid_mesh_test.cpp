#include "incision/mesh/grid_mesh.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <limits>
#include <set>

#include "incision/base/input_error.h"

namespace incision {
namespace {

std::set<std::array<int, 4>> asSets(std::vector<std::array<int, 4>> elements) {
  for (auto& element : elements) std::sort(element.begin(), element.end());
  return {elements.begin(), elements.end()};
}

TEST(GridMesh, OneCellIsSixTetrahedraRoundItsDiagonal) {
  const TetMesh mesh = gridMesh({{1, 1, 1}, Vec3::Constant(0.1), Vec3::Zero()});
  const std::vector<std::array<int, 4>> kuhn = {{0, 4, 6, 7}, {0, 4, 7, 5}, {0, 2, 7, 6},
                                                {0, 2, 3, 7}, {0, 1, 5, 7}, {0, 1, 7, 3}};
  EXPECT_EQ(mesh.elements.size(), 6u);
  EXPECT_EQ(asSets(mesh.elements), asSets(kuhn));
}

TEST(GridMesh, VolumesArePositiveAndSumToTheBox) {
  const Vec3 size(1.5, 0.25, 0.7);
  const TetMesh mesh = gridMesh({{5, 2, 3}, size, Vec3(-3, 2, 0.1)});
  double volume = 0;
  for (std::size_t e = 0; e < mesh.elements.size(); ++e) {
    const double v = elementVolume(mesh, static_cast<int>(e));
    EXPECT_GT(v, 0);
    volume += v;
  }
  EXPECT_EQ(mesh.elements.size(), 6u * 5 * 2 * 3);
  // Rounding of 180 terms and of coordinates up to three box lengths from the origin.
  EXPECT_NEAR(volume, size.prod(), 1e-13 * size.prod());
}

TEST(GridMesh, NodesLieInTheStatedOrderAndReachTheFarCornerExactly) {
  const GridSettings grid{{3, 4, 7}, Vec3(0.3, 0.7, 1.1), Vec3(0, 0, 0)};
  const TetMesh mesh = gridMesh(grid);
  ASSERT_EQ(mesh.nodes.size(), 4u * 5 * 8);
  const Vec3 node = mesh.nodes[(2 * 5 + 3) * 8 + 6];
  // One division and one product: two roundings.
  EXPECT_NEAR((node - Vec3(0.3 * 2 / 3, 0.7 * 3 / 4, 1.1 * 6 / 7)).norm(), 0, 1e-15);
  EXPECT_EQ(mesh.nodes.front(), grid.origin);
  EXPECT_EQ(mesh.nodes.back(), grid.size);
}

TEST(GridMesh, NeighbouringCellsFitTogether) {
  const TetMesh mesh = gridMesh({{4, 3, 2}, Vec3(4, 3, 2), Vec3::Zero()});
  const MeshTopology topology = buildTopology(mesh);
  int boundary_faces = 0;
  for (const auto& neighbours : topology.neighbours)
    boundary_faces += static_cast<int>(std::count(neighbours.begin(), neighbours.end(), -1));
  EXPECT_EQ(boundary_faces, 2 * 2 * (4 * 3 + 3 * 2 + 4 * 2));  // two triangles on each square of the skin
}

TEST(GridMesh, RefusesSettingsThatMakeNoGrid) {
  constexpr double INF = std::numeric_limits<double>::infinity();
  constexpr double NAN_VALUE = std::numeric_limits<double>::quiet_NaN();
  const Vec3 one = Vec3::Ones(), zero = Vec3::Zero();
  EXPECT_THROW(gridMesh({{0, 1, 1}, one, zero}), InputError);
  EXPECT_THROW(gridMesh({{1, -1, -1}, one, zero}), InputError);
  EXPECT_THROW(gridMesh({{2000, 2000, 2}, one, zero}), InputError);
  EXPECT_THROW(gridMesh({{2147483647, 2147483647, 2147483647}, one, zero}), InputError);
  for (double bad : {0.0, -1.0, INF, NAN_VALUE, 1e300})
    EXPECT_THROW(gridMesh({{1, 1, 1}, {1, bad, 1}, zero}), InputError);
  for (double bad : {INF, NAN_VALUE, -1e300}) EXPECT_THROW(gridMesh({{1, 1, 1}, one, {0, 0, bad}}), InputError);
}

TEST(GridMesh, RefusesCellsThatRoundingWouldFlatten) {
  EXPECT_THROW(gridMesh({{1, 1, 1}, {1, 1, 1e-13}, Vec3::Zero()}), InputError);
  EXPECT_THROW(gridMesh({{1, 1, 1}, Vec3::Constant(1e-9), Vec3::Constant(1e8)}), InputError);
}

TEST(GridMesh, ErrorsNameTheKeyAndTheValue) {
  try {
    gridMesh({{4, 0, 4}, Vec3::Ones(), Vec3::Zero()});
    FAIL() << "no error";
  } catch (const InputError& error) {
    EXPECT_EQ(std::string(error.what()), "grid.cells: [4, 0, 4]: each must be at least 1");
  }
}

}  // namespace
}  // namespace incision
