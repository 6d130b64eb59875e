#include "incision/solver/piecewise_solver.h"

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
  std::vector<bool> fixed(copies, false), direct(copies);
  std::vector<double> mass(copies, 0), stiffness(copies, 0);
  for (std::size_t c = 0; c < copies; ++c) {
    const int group = change.group[c];
    size[group] += change.left_out[c] ? 0 : 1;
    fixed[group] = fixed[group] || change.left_out[c];
    mass[group] += factors.mass * assembly.massDiagonal()[c];
    stiffness[group] += factors.stiffness * assembly.stiffnessDiagonal()[c];
  }
  for (std::size_t g = 0; g < copies; ++g)
    direct[g] = size[g] <= direct_up_to_ || (!fixed[g] && stiffness[g] > MASS_LOST * mass[g]);
  return direct;
}

void PiecewiseSolver::systemChanged(const Assembly& assembly, const SystemChange& change,
                                    const SystemFactors& factors) {
  const std::vector<bool> direct_groups = directGroups(assembly, change, factors);
  std::vector<bool> not_direct = change.left_out, not_iterative = change.left_out;
  const bool was_iterative = any_iterative_;
  any_direct_ = any_iterative_ = false;
  for (std::size_t c = 0; c < change.group.size(); ++c) {
    if (change.left_out[c]) continue;
    const bool direct = direct_groups[change.group[c]];
    (direct ? not_iterative : not_direct)[c] = true;
    (direct ? any_direct_ : any_iterative_) = true;
  }
  const auto changeWithout = [&](const std::vector<bool>& left_out) {
    return SystemChange{left_out, change.piece, change.group, change.touched};
  };
  if (any_direct_) direct_.systemChanged(assembly, changeWithout(not_direct), factors);
  // The iteration edits what it knew, so it hears of its last group's end: from no rows it begins afresh.
  if (any_iterative_ || was_iterative) iterative_.systemChanged(assembly, changeWithout(not_iterative), factors);
}

void PiecewiseSolver::matrixChanged(const std::vector<Vec3>& x) {
  if (any_direct_) direct_.matrixChanged(x);
  if (any_iterative_) iterative_.matrixChanged(x);
}

bool PiecewiseSolver::springsChanged(const std::vector<Spring>& springs, double time_step) {
  return (!any_direct_ || direct_.springsChanged(springs, time_step)) &&
         (!any_iterative_ || iterative_.springsChanged(springs, time_step));
}

int PiecewiseSolver::correct(const std::vector<Vec3>& r, const SolveDemand& demand, const Basis* basis,
                             std::vector<Vec3>* d, std::vector<Vec3>* left) {
  if (any_direct_) direct_.correct(r, demand, basis, d, left);
  return any_iterative_ ? iterative_.correct(r, demand, basis, d, left) : 0;
}

/// A solver that has nothing to do may have a memory of another system.
void PiecewiseSolver::keep(SolverMemory* memory) const {
  memory->blocks.clear();
  memory->coarse_blocks.clear();
  memory->idle = 0;
  if (any_direct_) direct_.keep(memory);
  if (any_iterative_) iterative_.keep(memory);
}

void PiecewiseSolver::recall(const SolverMemory& memory) {
  if (any_direct_) direct_.recall(memory);
  if (any_iterative_) iterative_.recall(memory);
}

}  // namespace incision
