#pragma once

#include "incision/solver/direct_solver.h"
#include "incision/solver/iterative_solver.h"

namespace incision {

/// Factorises small pieces and iterates on the others. Pieces do not touch each other's unknowns, so each solver takes
/// the other's copies for held. Small pieces are where an iteration does worst: fragments much thinner than their
/// elements are beyond float, and they cost a factorisation next to nothing.
class PiecewiseSolver : public LinearSolver {
 public:
  /// Pieces of up to `direct_up_to` free copies are factorised.
  PiecewiseSolver(double tolerance, int direct_up_to) : direct_up_to_(direct_up_to), iterative_(tolerance) {}

  void systemChanged(const Assembly& assembly, const SystemChange& change, const SystemFactors& factors) override;
  bool matrixChanged(const std::vector<Vec3>& x) override;
  SolveStats solve(const Residual& residual, const std::vector<double>& rounding, const Basis& basis,
                   std::vector<Vec3>* dv) override;

 private:
  int direct_up_to_;
  bool any_small_ = false, any_large_ = false;
  DirectSolver direct_;
  IterativeSolver iterative_;
};

}  // namespace incision
