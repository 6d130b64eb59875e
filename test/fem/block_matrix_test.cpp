#include "incision/fem/block_matrix.h"

#include <gtest/gtest.h>

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>
#include <memory>

#include "support/rig.h"

namespace incision {
namespace {

const Material BLOCK_TISSUE = {1e5, 0.4, 1100, 0, 0};

// Some of the copies lie in one region, some in another, some at the border.
std::vector<RegionSettings> stiffUpperCorner() {
  RegionSettings region;
  region.place = {Vec3(0.29, 0.24, -1), Vec3(1, 1, 1)};
  region.young_modulus = 3e6;
  region.poisson_ratio = 0.2;
  region.density = 500;
  return {region};
}

struct Tissue {
  Mass mass;
  bool in_regions;
};

class SystemMatrix : public ::testing::TestWithParam<Tissue> {
 protected:
  SystemMatrix() : rig(block({2, 2, 1}, Vec3(0.6, 0.5, 0.3)), {}) {
    if (GetParam().in_regions) materials = Materials(rig.mesh.mesh(), BLOCK_TISSUE, stiffUpperCorner());
    rig.cut(plane(Vec3(0.28, 0.2, 0.1), Vec3(1, 0.3, 0.2)));
    rig.cut(rectangle(Vec3(0.6, 0.22, 0.1), Vec3(0, 1, 0.1), Vec3::UnitX(), 0.5, 0));
    const std::vector<Vec3> moves = randomVectors(rig.motion.x.size(), 0.05, 9);
    for (std::size_t c = 0; c < moves.size(); ++c) rig.motion.x[c] += moves[c];
    assembly = std::make_unique<Assembly>(rig.mesh, materials, GetParam().mass, Pressure::ELEMENT, true, 1);
    assembly->topologyChanged(rig.motion.x);
    assembly->rotate(rig.motion.x);
  }

  Rig rig;
  Materials materials{rig.mesh.mesh(), BLOCK_TISSUE};
  std::unique_ptr<Assembly> assembly;
};

TEST_P(SystemMatrix, IsTheDifferenceOfTheElasticForces) {
  const Eigen::MatrixXd K = systemMatrix(*assembly, {0, 1}, allCopies(rig.mesh));
  std::vector<Vec3> y = rig.motion.x, before, after;
  assembly->elasticForces(y, &before);
  for (std::size_t d = 0; d < y.size(); ++d)
    for (int j = 0; j < 3; ++j) {
      y[d][j] += 1;  // any step will do, as the forces are affine
      assembly->elasticForces(y, &after);
      y[d] = rig.motion.x[d];
      for (std::size_t c = 0; c < y.size(); ++c)
        for (int i = 0; i < 3; ++i)
          EXPECT_NEAR(K(3 * c + i, 3 * d + j), after[c][i] - before[c][i], 1e-11 * K.cwiseAbs().maxCoeff());
    }
}

TEST_P(SystemMatrix, OfTheMassIsWhatMultiplyMassDoes) {
  const Eigen::MatrixXd M = systemMatrix(*assembly, {1, 0}, allCopies(rig.mesh));
  const std::vector<Vec3> w = randomVectors(rig.motion.x.size(), 1, 4);
  std::vector<Vec3> Mw;
  assembly->multiplyMass(w, &Mw);
  Eigen::VectorXd flat(3 * w.size());
  for (std::size_t c = 0; c < w.size(); ++c) flat.segment<3>(3 * c) = w[c];
  flat = M * flat;
  for (std::size_t c = 0; c < w.size(); ++c) EXPECT_LT((flat.segment<3>(3 * c) - Mw[c]).norm(), 1e-14 * largest(Mw));
}

TEST_P(SystemMatrix, IsSymmetricAndPositive) {
  const Eigen::MatrixXd A = systemMatrix(*assembly, {1, 1e-4}, allCopies(rig.mesh));
  EXPECT_LT((A - A.transpose()).cwiseAbs().maxCoeff(), 1e-14 * A.cwiseAbs().maxCoeff());
  EXPECT_GT(Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd>(A).eigenvalues().minCoeff(), 0);
}

TEST_P(SystemMatrix, LeavesHeldCopiesOut) {
  std::vector<int> some;
  for (int c = rig.mesh.numCopies() - 1; c >= 0; --c)
    if (c % 3 != 0) some.push_back(c);
  BlockPattern pattern;
  findPattern(*assembly, some, &pattern);
  EXPECT_EQ(pattern.copies, some);
  for (int c = 0; c < rig.mesh.numCopies(); ++c)
    EXPECT_EQ(pattern.row_of[c], c % 3 == 0 ? -1 : std::find(some.begin(), some.end(), c) - some.begin());
  const Eigen::MatrixXd all = systemMatrix(*assembly, {1, 1}, allCopies(rig.mesh));
  const Eigen::MatrixXd reduced = systemMatrix(*assembly, {1, 1}, some);
  for (std::size_t r = 0; r < some.size(); ++r)
    for (std::size_t s = 0; s < some.size(); ++s)
      EXPECT_LT((reduced.block<3, 3>(3 * r, 3 * s) - all.block<3, 3>(3 * some[r], 3 * some[s])).norm(),
                1e-13 * all.cwiseAbs().maxCoeff());
}

TEST_P(SystemMatrix, DiagonalIsTheMeanOfEachBlocksDiagonal) {
  const SystemFactors factors = {1.3, 2e-4};
  const Eigen::MatrixXd A = systemMatrix(*assembly, factors, allCopies(rig.mesh));
  for (int c = 0; c < rig.mesh.numCopies(); ++c)
    EXPECT_NEAR(diagonalOf(*assembly, factors, c) / A.diagonal().segment<3>(3 * c).mean(), 1, 1e-12);
}

TEST_P(SystemMatrix, InFloatIsTheScaledOneInDouble) {
  const SystemFactors factors = {1, 1e-4};
  BlockPattern pattern;
  findPattern(*assembly, allCopies(rig.mesh), &pattern);
  std::vector<double> scale, in_double;
  for (int c : pattern.copies) scale.push_back(1 / std::sqrt(diagonalOf(*assembly, factors, c)));
  std::vector<float> in_float;
  BlockAssembler<double>().assemble(*assembly, pattern, factors, scale, &in_double);
  BlockAssembler<float>().assemble(*assembly, pattern, factors, scale, &in_float);
  const Eigen::MatrixXd A = systemMatrix(*assembly, factors, allCopies(rig.mesh));
  for (int r = 0; r < pattern.rows(); ++r)
    for (int k = pattern.row_start[r]; k < pattern.row_start[r + 1]; ++k)
      for (int i = 0; i < 3; ++i)
        for (int j = 0; j < 3; ++j) {
          const int at = BLOCK_SIZE * k + 3 * j + i, s = pattern.column[k];
          EXPECT_NEAR(in_double[at], scale[r] * scale[s] * A(3 * r + i, 3 * s + j), 1e-13);
          EXPECT_NEAR(in_float[at], in_double[at], 1e-5);
        }
}

INSTANTIATE_TEST_SUITE_P(BlockMatrix, SystemMatrix,
                         ::testing::Values(Tissue{Mass::LUMPED, false}, Tissue{Mass::LUMPED, true},
                                           Tissue{Mass::CONSISTENT, false}, Tissue{Mass::CONSISTENT, true}));

}  // namespace
}  // namespace incision
