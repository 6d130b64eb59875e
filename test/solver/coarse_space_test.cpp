#include "incision/solver/coarse_space.h"

#include <gtest/gtest.h>

#include <cmath>

#include "support/rig.h"

namespace incision {
namespace {

TEST(CoarseSpace, AddsNothingOnceItsMatrixIsNotPositiveDefinite) {
  Rig rig(block({8, 8, 8}, Vec3::Ones()), {});
  const Assembly& assembly = rig.step.assembly();
  const NodeOrder order = orderNodes(rig.mesh.mesh(), 64);
  const SystemFactors factors = {1, 1e-4};
  BlockPattern pattern;
  findPattern(assembly, orderCopies(rig.mesh, order, std::vector<bool>(rig.mesh.numCopies(), false)), &pattern);
  const Aggregates aggregates = aggregate(rig.mesh, order, pattern);
  std::vector<double> scale;
  for (int c : pattern.copies) scale.push_back(1 / std::sqrt(diagonalOf(assembly, factors, c)));
  std::vector<float> blocks;
  BlockAssembler<float>().assemble(assembly, pattern, factors, scale, &blocks);
  const std::vector<Vec4f> r(pattern.rows(), Vec4f(1, 2, 3, 0));
  CoarseSpace coarse;
  coarse.topologyChanged(pattern, aggregates, scale);
  const auto largestCorrection = [&] {
    coarse.matrixChanged(rig.motion.x, blocks, 1);
    coarse.springsChanged(CoupledRows(), 1);
    for (int a = 0; a < aggregates.count(); ++a) coarse.restrictAggregate(a, r);
    coarse.solve();
    float largest = 0;
    for (int row = 0; row < pattern.rows(); ++row) largest = std::max(largest, coarse.prolong(row).norm());
    return largest;
  };
  EXPECT_GT(largestCorrection(), 0);

  // Ten times the spring of two aggregates, and no more on the diagonal.
  for (int row = 0; row < pattern.rows(); ++row)
    for (int k = pattern.row_start[row]; k < pattern.row_start[row + 1]; ++k)
      if (aggregates.of[row] != aggregates.of[pattern.column[k]])
        for (int i = 0; i < BLOCK_SIZE; ++i) blocks[BLOCK_SIZE * k + i] *= 10;
  EXPECT_EQ(largestCorrection(), 0);
}

}  // namespace
}  // namespace incision
