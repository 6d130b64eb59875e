#include "incision/solver/piecewise_solver.h"

#include <algorithm>

namespace incision {

void PiecewiseSolver::topologyChanged(const Assembly& assembly, const std::vector<bool>& held,
                                      const std::vector<int>& piece, const SystemFactors& factors) {
  std::vector<int> size(piece.size(), 0);
  for (std::size_t c = 0; c < piece.size(); ++c) size[piece[c]] += held[c] ? 0 : 1;
  std::vector<bool> not_small = held, not_large = held;
  any_small_ = any_large_ = false;
  for (std::size_t c = 0; c < piece.size(); ++c) {
    if (held[c]) continue;
    const bool small = size[piece[c]] <= direct_up_to_;
    (small ? not_large : not_small)[c] = true;
    (small ? any_small_ : any_large_) = true;
  }
  if (any_small_) direct_.topologyChanged(assembly, not_small, piece, factors);
  if (any_large_) iterative_.topologyChanged(assembly, not_large, piece, factors);
}

bool PiecewiseSolver::matrixChanged(const std::vector<Vec3>& x) {
  return (!any_small_ || direct_.matrixChanged(x)) && (!any_large_ || iterative_.matrixChanged(x));
}

SolveStats PiecewiseSolver::solve(const Residual& residual, const std::vector<double>& rounding,
                                  std::vector<Vec3>* dv) {
  SolveStats stats;
  if (any_small_) stats = direct_.solve(residual, rounding, dv);
  if (!any_large_) return stats;
  const double small_residual = stats.residual;
  stats = iterative_.solve(residual, rounding, dv);
  stats.residual = std::max(stats.residual, small_residual);
  return stats;
}

}  // namespace incision
