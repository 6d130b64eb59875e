#pragma once

#include "incision/solver/direct_solver.h"
#include "incision/solver/iterative_solver.h"

namespace incision {

/// Factorises small groups of pieces and iterates on the others. Groups do not touch each other's unknowns, so each
/// solver takes the other's copies for held. Small pieces are where an iteration does worst: fragments much thinner
/// than their elements are beyond float, and they cost a factorisation next to nothing.
class PiecewiseSolver : public LinearSolver {
 public:
  /// Groups of up to `direct_up_to` free copies are factorised.
  PiecewiseSolver(double tolerance, int direct_up_to) : direct_up_to_(direct_up_to), iterative_(tolerance) {}

  void systemChanged(const Assembly& assembly, const SystemChange& change, const SystemFactors& factors) override;
  void matrixChanged(const std::vector<Vec3>& x) override;
  bool couplingsChanged(const std::vector<Coupling>& couplings, double time_step) override;
  SolveStats solve(const Residual& residual, const std::vector<double>& rounding, const Basis& basis,
                   std::vector<Vec3>* dv) override;

 private:
  int direct_up_to_;
  bool any_small_ = false, any_large_ = false;
  DirectSolver direct_;
  IterativeSolver iterative_;
};

}  // namespace incision
