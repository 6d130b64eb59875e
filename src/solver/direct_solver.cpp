#include "incision/solver/direct_solver.h"

#include <cmath>

namespace incision {
namespace {

/// Relative residual that a backward stable factorisation leaves, and below which its rounding is not worth reporting.
constexpr double ATTAINABLE = 1e-12;

}  // namespace

void DirectSolver::systemChanged(const Assembly& assembly, const SystemChange& change, const SystemFactors& factors) {
  assembly_ = &assembly;
  factors_ = factors;
  std::vector<int> free_copies;
  std::vector<double> scale;
  for (int c = 0; c < assembly.mesh().numCopies(); ++c) {
    if (change.held[c]) continue;
    free_copies.push_back(c);
    scale.push_back(1 / std::sqrt(diagonalOf(assembly, factors, c)));
  }
  findPattern(assembly, free_copies, &pattern_);
  ones_.assign(free_copies.size(), 1);
  norms_.systemChanged(assembly, free_copies, change.piece, scale);

  LowerTriangle lower;
  lower.column_start.push_back(0);
  source_.clear();
  // The matrix is symmetric: row r of blocks read from its diagonal on is column r of the lower triangle.
  for (int r = 0; r < pattern_.rows(); ++r)
    for (int j = 0; j < 3; ++j) {
      for (int k = pattern_.diagonal[r]; k < pattern_.row_start[r + 1]; ++k)
        for (int i = k == pattern_.diagonal[r] ? j : 0; i < 3; ++i) {
          lower.row.push_back(3 * pattern_.column[k] + i);
          source_.push_back(BLOCK_SIZE * k + 3 * i + j);
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

SolveStats DirectSolver::solve(const Residual& residual, const std::vector<double>& rounding, const Basis&,
                               std::vector<Vec3>* dv) {
  SolveStats stats;
  if (pattern_.rows() == 0) return stats;
  for (int c : pattern_.copies) (*dv)[c].setZero();
  residual(*dv, &residual_);
  norms_.setRightHandSide(residual_, rounding, ATTAINABLE);
  if (norms_.total() == 0) return stats;
  b_.resize(3 * pattern_.rows());
  for (int r = 0; r < pattern_.rows(); ++r)
    for (int i = 0; i < 3; ++i) b_[3 * r + i] = residual_[pattern_.copies[r]][i];
  cholesky_.solve(b_, &solution_);
  for (int r = 0; r < pattern_.rows(); ++r)
    for (int i = 0; i < 3; ++i) (*dv)[pattern_.copies[r]][i] = solution_[3 * r + i];
  residual(*dv, &residual_);
  stats.residual = norms_.worstRatio(residual_);
  return stats;
}

}  // namespace incision
