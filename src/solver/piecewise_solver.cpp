#include "incision/solver/piecewise_solver.h"

#include <algorithm>

namespace incision {
namespace {

/// Stiffness over mass beyond which a float that holds both has no digit left for the mass: 1/ε.
constexpr double MASS_LOST = 8e6;

}  // namespace

/// Which groups to factorise.
std::vector<bool> PiecewiseSolver::directGroups(const Assembly& assembly, const SystemChange& change,
                                                const SystemFactors& factors) const {
  const std::size_t copies = change.group.size();
  std::vector<int> size(copies, 0);
  std::vector<bool> held(copies, false), direct(copies);
  std::vector<double> mass(copies, 0), stiffness(copies, 0);
  for (std::size_t c = 0; c < copies; ++c) {
    const int group = change.group[c];
    size[group] += change.held[c] ? 0 : 1;
    held[group] = held[group] || change.held[c];
    mass[group] += factors.mass * assembly.massDiagonal()[c];
    stiffness[group] += factors.stiffness * assembly.stiffnessDiagonal()[c];
  }
  for (std::size_t g = 0; g < copies; ++g)
    direct[g] = size[g] <= direct_up_to_ || (!held[g] && stiffness[g] > MASS_LOST * mass[g]);
  return direct;
}

void PiecewiseSolver::systemChanged(const Assembly& assembly, const SystemChange& change,
                                    const SystemFactors& factors) {
  const std::vector<bool> direct_groups = directGroups(assembly, change, factors);
  std::vector<bool> not_direct = change.held, not_iterative = change.held;
  const bool was_iterative = any_iterative_;
  any_direct_ = any_iterative_ = false;
  for (std::size_t c = 0; c < change.group.size(); ++c) {
    if (change.held[c]) continue;
    const bool direct = direct_groups[change.group[c]];
    (direct ? not_iterative : not_direct)[c] = true;
    (direct ? any_direct_ : any_iterative_) = true;
  }
  const auto change_but = [&](const std::vector<bool>& held) {
    return SystemChange{held, change.piece, change.group, change.touched};
  };
  if (any_direct_) direct_.systemChanged(assembly, change_but(not_direct), factors);
  // The iteration edits what it knew, so it hears of its last group's end: from no rows it begins afresh.
  if (any_iterative_ || was_iterative) iterative_.systemChanged(assembly, change_but(not_iterative), factors);
}

void PiecewiseSolver::matrixChanged(const std::vector<Vec3>& x) {
  if (any_direct_) direct_.matrixChanged(x);
  if (any_iterative_) iterative_.matrixChanged(x);
}

bool PiecewiseSolver::couplingsChanged(const std::vector<Coupling>& couplings, double time_step) {
  return (!any_direct_ || direct_.couplingsChanged(couplings, time_step)) &&
         (!any_iterative_ || iterative_.couplingsChanged(couplings, time_step));
}

SolveStats PiecewiseSolver::solve(const Residual& residual, const std::vector<double>& rounding, const Basis& basis,
                                  std::vector<Vec3>* dv) {
  SolveStats stats;
  if (any_direct_) stats = direct_.solve(residual, rounding, basis, dv);
  if (!any_iterative_) return stats;
  const double direct_residual = stats.residual;
  stats = iterative_.solve(residual, rounding, basis, dv);
  stats.residual = std::max(stats.residual, direct_residual);
  return stats;
}

}  // namespace incision
