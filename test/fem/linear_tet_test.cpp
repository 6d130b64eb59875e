#include "incision/fem/linear_tet.h"

#include <gtest/gtest.h>

#include <Eigen/LU>

#include "support/rig.h"

namespace incision {
namespace {

TEST(LinearTet, GradientsReproduceALinearField) {
  const TetMesh mesh = block({2, 3, 2}, Vec3(1, 0.3, 2), Vec3(5, -1, 0));
  Mat3 slope;
  slope << 1, 2, 3, -4, 5, 6, 7, -8, 9;
  const std::vector<RestElement> rest = restElements(mesh);
  double volume = 0;
  for (std::size_t e = 0; e < rest.size(); ++e) {
    std::array<Vec3, 4> y;
    for (int I = 0; I < 4; ++I) y[I] = slope * mesh.nodes[mesh.elements[e][I]] + Vec3(1, 2, 3);
    EXPECT_LT((gradient(y[0], y[1], y[2], y[3], rest[e]) - slope).norm(), 1e-12 * slope.norm());
    EXPECT_LT(rest[e].gradients().rowwise().sum().norm(), 1e-12 * rest[e].b.norm());
    volume += rest[e].volume;
  }
  EXPECT_NEAR(volume, 0.6, 1e-12);
}

TEST(LinearTet, StressFollowsHooke) {
  const Material material = {2e5, 0.3, 1000, 0, 0};
  Mat3 F = Mat3::Identity();
  EXPECT_EQ(corotatedStress(F, material.lame()), Mat3::Zero());
  // Uniaxial stress: strain ε along x and −νε across leaves E ε alone.
  const double strain = 0.01;
  F.diagonal() = Vec3(1 + strain, 1 - 0.3 * strain, 1 - 0.3 * strain);
  EXPECT_LT((corotatedStress(F, material.lame()) - Vec3(2e5 * strain, 0, 0).asDiagonal().toDenseMatrix()).norm(), 1e-9);
  // Simple shear γ: τ = μ γ.
  F = Mat3::Identity();
  F(0, 1) = strain;
  EXPECT_NEAR(corotatedStress(F, material.lame())(0, 1), 2e5 / 2.6 * strain, 1e-9);
  EXPECT_NEAR(corotatedStress(F, material.lame())(1, 0), 2e5 / 2.6 * strain, 1e-9);
}

TEST(LinearTet, NearlyIncompressibleTissueHasItsBulkModulus) {
  const Material material = {1e6, 0.4999, 1000, 0, 0};
  const Mat3 squeezed = 0.99 * Mat3::Identity();
  const double pressure = 1e6 / (3 * (1 - 2 * 0.4999)) * 3 * 0.01;
  EXPECT_NEAR(corotatedStress(squeezed, material.lame())(2, 2), -pressure, 1e-8 * pressure);
}

}  // namespace
}  // namespace incision
