#include "incision/solver/linear_solver.h"

#include "incision/solver/piecewise_solver.h"

namespace incision {
namespace {

/// Up to this many free copies in a piece a factorisation is as quick as the iteration.
constexpr int DIRECT_UP_TO = 300;

/// With `method: iterative`, pieces no larger than one aggregate: the coarse space would solve them anyway.
constexpr int ONE_AGGREGATE = 64;

}  // namespace

std::unique_ptr<LinearSolver> makeLinearSolver(const SolverSettings& settings) {
  if (settings.method == Method::DIRECT) return std::make_unique<DirectSolver>();
  return std::make_unique<PiecewiseSolver>(settings.tolerance,
                                           settings.method == Method::AUTO ? DIRECT_UP_TO : ONE_AGGREGATE);
}

}  // namespace incision
