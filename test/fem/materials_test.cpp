#include "incision/fem/materials.h"

#include <gtest/gtest.h>

#include <cmath>

#include "incision/mesh/grid_mesh.h"

namespace incision {
namespace {

constexpr double ROUNDING = 1e-14;  // relative

const Material TISSUE = {3e4, 0.3, 1000, 0.5, 0.01};

TEST(Materials, AGridsElementsHaveTheSizeOfItsCells) {
  const TetMesh mesh = gridMesh({{4, 3, 2}, Vec3(0.4, 0.3, 0.2), Vec3::Zero()});
  const Materials materials(mesh, TISSUE);
  for (std::size_t e = 0; e < mesh.elements.size(); ++e)
    EXPECT_NEAR(materials.size(static_cast<int>(e)), 0.1, 0.1 * ROUNDING);
  EXPECT_NEAR(materials.meanSize(), 0.1, 0.1 * ROUNDING);
}

TEST(Materials, ElementsOfMeanSizeWouldFillTheBody) {
  TetMesh mesh = gridMesh({{2, 2, 2}, Vec3(1, 1, 1), Vec3::Zero()});
  for (Vec3& X : mesh.nodes) X.x() *= X.x();
  const Materials materials(mesh, TISSUE);
  EXPECT_GT(std::abs(materials.size(0) - materials.meanSize()), 0.01);
  const double elements = static_cast<double>(mesh.elements.size());
  EXPECT_NEAR(elements * std::pow(materials.meanSize(), 3) / 6, 1, 100 * ROUNDING);
}

TEST(Materials, AnElementTwiceAsLargeIsHalfAsStiff) {
  TetMesh mesh = gridMesh({{1, 1, 1}, Vec3(1, 1, 1), Vec3::Zero()});
  const Materials small(mesh, TISSUE);
  for (Vec3& X : mesh.nodes) X *= 2;
  const Materials large(mesh, TISSUE);
  EXPECT_NEAR(small.stiffness(0), TISSUE.young_modulus, TISSUE.young_modulus * ROUNDING);
  EXPECT_NEAR(large.stiffness(0), TISSUE.young_modulus / 2, TISSUE.young_modulus * ROUNDING);
}

}  // namespace
}  // namespace incision
