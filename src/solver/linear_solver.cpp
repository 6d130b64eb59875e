#include "incision/solver/linear_solver.h"

#include "incision/solver/piecewise_solver.h"

namespace incision {
namespace {

/// Up to this many free copies, one aggregate, a piece is factorised: the coarse space would solve it anyway.
constexpr int DIRECT_UP_TO = 64;

/// Up to this many free copies a piece is factorised by `method: auto` where the matrix never changes, so that only two
/// triangular solves remain in a step.
constexpr int DIRECT_UP_TO_UNWARPED = 1000;

}  // namespace

std::unique_ptr<LinearSolver> makeLinearSolver(const SolverSettings& settings, bool warping) {
  if (settings.method == Method::DIRECT) return std::make_unique<DirectSolver>();
  const bool lasting = settings.method == Method::AUTO && !warping;
  return std::make_unique<PiecewiseSolver>(lasting ? DIRECT_UP_TO_UNWARPED : DIRECT_UP_TO);
}

}  // namespace incision
