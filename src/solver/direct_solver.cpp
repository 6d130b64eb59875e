#include "incision/solver/direct_solver.h"

#include <cmath>

namespace incision {
namespace {

/// Relative residual that a backward stable factorisation leaves, and below which its rounding is not worth reporting.
constexpr double ATTAINABLE = 1e-12;

}  // namespace

void DirectSolver::topologyChanged(const Assembly& assembly, const std::vector<bool>& held,
                                   const std::vector<int>& piece, const SystemFactors& factors) {
  assembly_ = &assembly;
  factors_ = factors;
  std::vector<int> free_copies;
  for (int c = 0; c < assembly.mesh().numCopies(); ++c)
    if (!held[c]) free_copies.push_back(c);
  findPattern(assembly, free_copies, &pattern_);
  ones_.assign(free_copies.size(), 1);
  const std::vector<double> diagonal = diagonalScale(assembly, factors);
  norms_.topologyChanged(assembly, free_copies, piece, diagonal);
  scale_.clear();
  for (int c : free_copies) scale_.push_back(1 / std::sqrt(diagonal[c]));
  r_.resize(free_copies.size());

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

SolveStats DirectSolver::solve(const Residual& residual, const std::vector<double>& rounding, std::vector<Vec3>* dv) {
  SolveStats stats;
  if (pattern_.rows() == 0) return stats;
  for (int c : pattern_.copies) (*dv)[c].setZero();
  takeResidual(residual, *dv);
  norms_.setRightHandSide(r_, rounding, ATTAINABLE);
  if (norms_.total() == 0) return stats;
  b_.resize(3 * pattern_.rows());
  for (int r = 0; r < pattern_.rows(); ++r)
    for (int i = 0; i < 3; ++i) b_[3 * r + i] = nodal_residual_[pattern_.copies[r]][i];
  cholesky_.solve(b_, &solution_);
  for (int r = 0; r < pattern_.rows(); ++r)
    for (int i = 0; i < 3; ++i) (*dv)[pattern_.copies[r]][i] = solution_[3 * r + i];
  takeResidual(residual, *dv);
  stats.residual = norms_.worstRatio(r_);
  return stats;
}

void DirectSolver::takeResidual(const Residual& residual, const std::vector<Vec3>& dv) {
  residual(dv, &nodal_residual_);
  for (int r = 0; r < pattern_.rows(); ++r) r_[r] = scale_[r] * nodal_residual_[pattern_.copies[r]];
}

}  // namespace incision
