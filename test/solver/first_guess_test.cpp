#include "incision/solver/first_guess.h"

#include <gtest/gtest.h>

#include <Eigen/Dense>

namespace incision {
namespace {

TEST(BestCombination, SolvesWhatASumOfTheBasisSolves) {
  const Eigen::Matrix<double, 6, BASIS_SIZE> U = Eigen::Matrix<double, 6, BASIS_SIZE>::Random();
  const BasisMatrix G = U.transpose() * U;
  const BasisVector c(0.3, -2, 5);
  EXPECT_LT((bestCombination(G, G * c) - c).norm(), 1e-10);
}

TEST(BestCombination, LeavesOutWhatTheOthersSpanAndWhatIsZero) {
  for (const BasisMatrix& U : {BasisMatrix{{1, 2, 0}, {0, 0, 0}, {3, 6, 1}},
                               BasisMatrix{{0, 1, 2}, {0, 3, 0}, {0, 0, 1}}, BasisMatrix(BasisMatrix::Zero())}) {
    const Eigen::Vector3d b(1, -2, 0.5);
    const BasisVector c = bestCombination(U.transpose() * U, U.transpose() * b);
    ASSERT_TRUE(c.allFinite());
    // The least squares residual is orthogonal to all of the basis.
    EXPECT_LT((U.transpose() * (b - U * c)).norm(), 1e-12);
  }
}

}  // namespace
}  // namespace incision
