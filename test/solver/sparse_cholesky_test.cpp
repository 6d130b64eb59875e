#include "incision/solver/sparse_cholesky.h"

#include <gtest/gtest.h>

#include <Eigen/Cholesky>
#include <random>

namespace incision {
namespace {

// A random sparse matrix of 3 × 3 blocks, positive definite through its diagonal.
class RandomSpd : public ::testing::TestWithParam<int> {
 protected:
  RandomSpd() {
    const int blocks = GetParam(), size = 3 * blocks;
    used_ = Eigen::MatrixXi::Identity(blocks, blocks);
    for (int k = 0; k < 3 * blocks; ++k) used_(generator_() % blocks, generator_() % blocks) = 1;
    used_ += used_.transpose().eval();
    for (int j = 0; j < size; ++j) {
      pattern_.column_start.push_back(static_cast<int>(pattern_.row.size()));
      for (int i = j; i < size; ++i)
        if (used_(i / 3, j / 3) != 0) pattern_.row.push_back(i);
    }
    pattern_.column_start.push_back(static_cast<int>(pattern_.row.size()));
  }

  // Gives the pattern new values and returns the matrix; `shift` moves its eigenvalues.
  Eigen::MatrixXd fill(double shift) {
    std::uniform_real_distribution<double> uniform(-1, 1);
    const int size = 3 * GetParam();
    Eigen::MatrixXd A = Eigen::MatrixXd::Zero(size, size);
    values_.clear();
    for (int j = 0; j < size; ++j)
      for (int k = pattern_.column_start[j]; k < pattern_.column_start[j + 1]; ++k)
        A(pattern_.row[k], j) = A(j, pattern_.row[k]) = uniform(generator_);
    A.diagonal().array() += A.cwiseAbs().rowwise().sum().array() + shift;
    for (int j = 0; j < size; ++j)
      for (int k = pattern_.column_start[j]; k < pattern_.column_start[j + 1]; ++k)
        values_.push_back(A(pattern_.row[k], j));
    return A;
  }

  void expectSolves(SparseCholesky* cholesky, const Eigen::MatrixXd& A) {
    const Eigen::VectorXd b = Eigen::VectorXd::LinSpaced(A.rows(), -1, 2);
    std::vector<double> x;
    cholesky->solve(std::vector<double>(b.begin(), b.end()), &x);
    const Eigen::VectorXd answer = A.ldlt().solve(b);
    ASSERT_EQ(static_cast<Eigen::Index>(x.size()), A.rows());
    const Eigen::VectorXd found = Eigen::Map<Eigen::VectorXd>(x.data(), A.rows());
    EXPECT_LT((found - answer).norm(), 1e-11 * answer.norm());
  }

  std::mt19937 generator_{5};
  Eigen::MatrixXi used_;
  LowerTriangle pattern_;
  std::vector<double> values_;
};

TEST_P(RandomSpd, IsSolvedAsByEigen) {
  for (const int block : {1, 3}) {
    SparseCholesky cholesky;
    cholesky.analyse(pattern_, block);
    for (int i = 0; i < 3; ++i) {  // analysed once for several sets of values
      const Eigen::MatrixXd A = fill(0.1);
      ASSERT_TRUE(cholesky.factorise(values_));
      expectSolves(&cholesky, A);
    }
  }
}

TEST_P(RandomSpd, NotPositiveDefiniteIsSaidAndForgiven) {
  SparseCholesky cholesky;
  cholesky.analyse(pattern_, 3);
  fill(-1e3);
  EXPECT_FALSE(cholesky.factorise(values_));
  const Eigen::MatrixXd A = fill(0.1);
  ASSERT_TRUE(cholesky.factorise(values_));
  expectSolves(&cholesky, A);
}

TEST_P(RandomSpd, MayBeAnalysedAnew) {
  SparseCholesky cholesky;
  cholesky.analyse({{0, 1}, {0}}, 1);
  ASSERT_TRUE(cholesky.factorise({4}));
  cholesky.analyse(pattern_, 3);
  const Eigen::MatrixXd A = fill(0.1);
  ASSERT_TRUE(cholesky.factorise(values_));
  expectSolves(&cholesky, A);
}

INSTANTIATE_TEST_SUITE_P(SparseCholesky, RandomSpd, ::testing::Values(1, 2, 20, 100));

}  // namespace
}  // namespace incision
