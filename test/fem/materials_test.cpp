#include "incision/fem/materials.h"

#include <gtest/gtest.h>

#include <cmath>

#include "incision/mesh/grid_mesh.h"

namespace incision {
namespace {

constexpr double SUM_ROUNDING = 1e-14;  // relative

const Material DAMPED = {3e4, 0.3, 1000, 0.5, 0.01};

TEST(Materials, AGridsElementsHaveTheSizeOfItsCells) {
  const TetMesh mesh = gridMesh({{4, 3, 2}, Vec3(0.4, 0.3, 0.2), Vec3::Zero()});
  const Materials materials(mesh, DAMPED);
  for (std::size_t e = 0; e < mesh.elements.size(); ++e)
    EXPECT_NEAR(materials.size(static_cast<int>(e)), 0.1, 0.1 * SUM_ROUNDING);
  EXPECT_NEAR(materials.meanSize(), 0.1, 0.1 * SUM_ROUNDING);
}

TEST(Materials, ElementsOfMeanSizeWouldFillTheBody) {
  TetMesh mesh = gridMesh({{2, 2, 2}, Vec3(1, 1, 1), Vec3::Zero()});
  for (Vec3& X : mesh.nodes) X.x() *= X.x();
  const Materials materials(mesh, DAMPED);
  EXPECT_GT(std::abs(materials.size(0) - materials.meanSize()), 0.01);
  const double elements = static_cast<double>(mesh.elements.size());
  EXPECT_NEAR(elements * std::pow(materials.meanSize(), 3) / 6, 1, 100 * SUM_ROUNDING);
}

TEST(Materials, AnElementTwiceAsLargeIsHalfAsStiff) {
  TetMesh mesh = gridMesh({{1, 1, 1}, Vec3(1, 1, 1), Vec3::Zero()});
  const Materials small(mesh, DAMPED);
  for (Vec3& X : mesh.nodes) X *= 2;
  const Materials large(mesh, DAMPED);
  EXPECT_NEAR(small.stiffness(0), DAMPED.young_modulus, DAMPED.young_modulus * SUM_ROUNDING);
  EXPECT_NEAR(large.stiffness(0), DAMPED.young_modulus / 2, DAMPED.young_modulus * SUM_ROUNDING);
}

TEST(Materials, WhatARegionDoesNotSayIsTheBodys) {
  const TetMesh mesh = gridMesh({{2, 1, 1}, Vec3(2, 1, 1), Vec3::Zero()});
  RegionSettings stiff, dense;
  stiff.place = {Vec3(1, 0, 0), Vec3(2, 1, 1)};
  stiff.young_modulus = 1e6;
  dense.place = {Vec3(0, 0, 0), Vec3(1, 1, 1)};
  dense.density = 2000;
  dense.poisson_ratio = 0.1;
  const Materials materials(mesh, DAMPED, {stiff, dense});
  for (std::size_t n = 0; n < mesh.elements.size(); ++n) {
    const int e = static_cast<int>(n);
    const bool is_stiff = mesh.nodes[mesh.elements[n][0]].x() + mesh.nodes[mesh.elements[n][3]].x() > 2.5 || n >= 6;
    EXPECT_EQ(materials.of(e).young_modulus, is_stiff ? 1e6 : DAMPED.young_modulus);
    EXPECT_EQ(materials.of(e).poisson_ratio, is_stiff ? DAMPED.poisson_ratio : 0.1);
    EXPECT_EQ(materials.of(e).density, is_stiff ? DAMPED.density : 2000);
    EXPECT_EQ(materials.lame(e).mu, materials.of(e).mu());
    const double ratio = materials.lame(e).lambda / materials.lame(e).mu;
    EXPECT_NEAR(materials.lameRatios()[materials.lameRatio(e)], ratio, SUM_ROUNDING * ratio);
  }
  EXPECT_EQ(materials.lameRatios().size(), 2u);
}

}  // namespace
}  // namespace incision
