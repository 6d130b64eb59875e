#include "incision/solver/piecewise_solver.h"

#include <algorithm>

namespace incision {

void PiecewiseSolver::systemChanged(const Assembly& assembly, const SystemChange& change,
                                    const SystemFactors& factors) {
  std::vector<int> size(change.group.size(), 0);
  for (std::size_t c = 0; c < size.size(); ++c) size[change.group[c]] += change.held[c] ? 0 : 1;
  std::vector<bool> not_small = change.held, not_large = change.held;
  const bool was_large = any_large_;
  any_small_ = any_large_ = false;
  for (std::size_t c = 0; c < size.size(); ++c) {
    if (change.held[c]) continue;
    const bool small = size[change.group[c]] <= direct_up_to_;
    (small ? not_large : not_small)[c] = true;
    (small ? any_small_ : any_large_) = true;
  }
  const auto change_but = [&](const std::vector<bool>& held) {
    return SystemChange{held, change.piece, change.group, change.touched};
  };
  if (any_small_) direct_.systemChanged(assembly, change_but(not_small), factors);
  // The iteration edits what it knew, so it hears of its last group's end: from no rows it begins afresh.
  if (any_large_ || was_large) iterative_.systemChanged(assembly, change_but(not_large), factors);
}

void PiecewiseSolver::matrixChanged(const std::vector<Vec3>& x) {
  if (any_small_) direct_.matrixChanged(x);
  if (any_large_) iterative_.matrixChanged(x);
}

bool PiecewiseSolver::couplingsChanged(const std::vector<Coupling>& couplings, double time_step) {
  return (!any_small_ || direct_.couplingsChanged(couplings, time_step)) &&
         (!any_large_ || iterative_.couplingsChanged(couplings, time_step));
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
