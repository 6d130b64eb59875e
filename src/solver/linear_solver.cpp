#include "incision/solver/linear_solver.h"

#include "incision/solver/direct_solver.h"
#include "incision/solver/iterative_solver.h"

namespace incision {
namespace {

/// Up to this many copies a factorisation is as quick as the iteration.
constexpr int DIRECT_UP_TO = 300;

}  // namespace

std::unique_ptr<LinearSolver> makeLinearSolver(const SolverSettings& settings, int copies) {
  const bool direct = settings.method == Method::DIRECT || (settings.method == Method::AUTO && copies <= DIRECT_UP_TO);
  if (direct) return std::make_unique<DirectSolver>();
  return std::make_unique<IterativeSolver>(settings.tolerance);
}

}  // namespace incision
