#include "incision/solver/direct_solver.h"

#include <cmath>

namespace incision {

void DirectSolver::topologyChanged(const Assembly& assembly, const std::vector<bool>& held, const std::vector<int>&,
                                   const SystemFactors& factors) {
  assembly_ = &assembly;
  factors_ = factors;
  std::vector<int> free_copies;
  for (int c = 0; c < assembly.mesh().numCopies(); ++c)
    if (!held[c]) free_copies.push_back(c);
  pattern_ = blockPattern(assembly, free_copies);
  ones_.assign(free_copies.size(), 1);
  const std::vector<double> diagonal = diagonalScale(assembly, factors);
  inverse_diagonal_.clear();
  for (int c : free_copies) inverse_diagonal_.push_back(1 / diagonal[c]);

  LowerTriangle lower;
  lower.column_start.push_back(0);
  source_.clear();
  // The matrix is symmetric: row r of blocks read from its diagonal on is column r of the lower triangle.
  for (int r = 0; r < pattern_.rows(); ++r)
    for (int j = 0; j < 3; ++j) {
      for (int k = pattern_.diagonal[r]; k < pattern_.row_start[r + 1]; ++k)
        for (int i = k == pattern_.diagonal[r] ? j : 0; i < 3; ++i) {
          lower.row.push_back(3 * pattern_.column[k] + i);
          source_.push_back(BLOCK_SIZE * k + 4 * i + j);
        }
      lower.column_start.push_back(static_cast<int>(lower.row.size()));
    }
  values_.resize(source_.size());
  if (pattern_.rows() > 0) cholesky_.analyse(lower, 3);
}

bool DirectSolver::matrixChanged(const std::vector<Vec3>&) {
  if (pattern_.rows() == 0) return true;
  assembler_.assemble(*assembly_, pattern_, factors_, ones_, &blocks_);
  for (std::size_t k = 0; k < source_.size(); ++k) values_[k] = blocks_[source_[k]];
  return cholesky_.factorise(values_);
}

SolveStats DirectSolver::solve(const Residual& residual, std::vector<Vec3>* dv) {
  if (pattern_.rows() == 0) return {};
  const auto scaledNorm = [&] {
    double sum = 0;
    for (int r = 0; r < pattern_.rows(); ++r) sum += inverse_diagonal_[r] * r_[pattern_.copies[r]].squaredNorm();
    return std::sqrt(sum);
  };
  for (int c : pattern_.copies) (*dv)[c].setZero();
  residual(*dv, &r_);
  const double b_norm = scaledNorm();
  b_.resize(3 * pattern_.rows());
  for (int r = 0; r < pattern_.rows(); ++r)
    for (int i = 0; i < 3; ++i) b_[3 * r + i] = r_[pattern_.copies[r]][i];
  cholesky_.solve(b_, &solution_);
  for (int r = 0; r < pattern_.rows(); ++r)
    for (int i = 0; i < 3; ++i) (*dv)[pattern_.copies[r]][i] = solution_[3 * r + i];
  residual(*dv, &r_);
  return {0, b_norm > 0 ? scaledNorm() / b_norm : 0};
}

}  // namespace incision
