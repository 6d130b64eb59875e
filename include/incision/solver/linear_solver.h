#pragma once

#include <functional>
#include <memory>
#include <vector>

#include "incision/fem/block_matrix.h"
#include "incision/solver/settings.h"

namespace incision {

/// What a solve took.
struct SolveStats {
  int iterations = 0;  ///< 0 for a direct solve
  double residual = 0;  ///< ‖r‖/‖b‖ in the norm scaled by the diagonal of A, r reckoned in double from the forces
};

/// The right-hand side less A Δv, at every copy, for a trial Δv at every copy; entries of held copies are ignored.
using Residual = std::function<void(const std::vector<Vec3>& dv, std::vector<Vec3>* r)>;

/// Solves A Δv = b, A = mass M + stiffness K, for the free copies.
class LinearSolver {
 public:
  virtual ~LinearSolver() = default;

  /// After a cut, or when copies become held or free. `held` tells of each copy whether it is; `piece` numbers the
  /// pieces; `assembly` must outlive the solver.
  virtual void topologyChanged(const Assembly& assembly, const std::vector<bool>& held, const std::vector<int>& piece,
                               const SystemFactors& factors) = 0;

  /// After the rotations changed; `x` are the copies' positions [m]. Returns false when A is not positive definite.
  virtual bool matrixChanged(const std::vector<Vec3>& x) = 0;

  /// Improves `dv`, which comes with the held copies' values and a guess at the others.
  virtual SolveStats solve(const Residual& residual, std::vector<Vec3>* dv) = 0;
};

/// `copies`: of the body, by which AUTO chooses.
std::unique_ptr<LinearSolver> makeLinearSolver(const SolverSettings& settings, int copies);

}  // namespace incision
