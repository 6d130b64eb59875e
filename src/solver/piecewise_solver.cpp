#include "incision/solver/piecewise_solver.h"

#include <algorithm>

namespace incision {

void PiecewiseSolver::systemChanged(const Assembly& assembly, const SystemChange& change,
                                    const SystemFactors& factors) {
  std::vector<int> size(change.piece.size(), 0);
  for (std::size_t c = 0; c < size.size(); ++c) size[change.piece[c]] += change.held[c] ? 0 : 1;
  std::vector<bool> not_small = change.held, not_large = change.held;
  any_small_ = any_large_ = false;
  for (std::size_t c = 0; c < size.size(); ++c) {
    if (change.held[c]) continue;
    const bool small = size[change.piece[c]] <= direct_up_to_;
    (small ? not_large : not_small)[c] = true;
    (small ? any_small_ : any_large_) = true;
  }
  if (any_small_) direct_.systemChanged(assembly, {not_small, change.piece, change.touched}, factors);
  // Pieces only ever get smaller, so once no large one is left there will be none.
  if (any_large_) iterative_.systemChanged(assembly, {not_large, change.piece, change.touched}, factors);
}

bool PiecewiseSolver::matrixChanged(const std::vector<Vec3>& x) {
  return (!any_small_ || direct_.matrixChanged(x)) && (!any_large_ || iterative_.matrixChanged(x));
}

SolveStats PiecewiseSolver::solve(const Residual& residual, const std::vector<double>& rounding, const Basis& basis,
                                  std::vector<Vec3>* dv) {
  SolveStats stats;
  if (any_small_) stats = direct_.solve(residual, rounding, basis, dv);
  if (!any_large_) return stats;
  const double small_residual = stats.residual;
  stats = iterative_.solve(residual, rounding, basis, dv);
  stats.residual = std::max(stats.residual, small_residual);
  return stats;
}

}  // namespace incision
