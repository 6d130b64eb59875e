#include "incision/solver/linear_solver.h"

#include "incision/solver/piecewise_solver.h"

namespace incision {
namespace {

/// Up to this many free copies in a piece a factorisation is as quick as the iteration.
constexpr int DIRECT_UP_TO = 300;

/// The same where the matrix never changes, so that only two triangular solves are left in a step.
constexpr int DIRECT_UP_TO_UNWARPED = 1000;

/// With `method: iterative`, pieces no larger than one aggregate: the coarse space would solve them anyway.
constexpr int ONE_AGGREGATE = 64;

}  // namespace

std::unique_ptr<LinearSolver> makeLinearSolver(const SolverSettings& settings, bool warping) {
  if (settings.method == Method::DIRECT) return std::make_unique<DirectSolver>();
  const int direct_up_to = settings.method == Method::ITERATIVE ? ONE_AGGREGATE
                           : warping                            ? DIRECT_UP_TO
                                                                : DIRECT_UP_TO_UNWARPED;
  return std::make_unique<PiecewiseSolver>(settings.tolerance, direct_up_to);
}

}  // namespace incision
