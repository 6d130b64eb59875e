#pragma once

#include "incision/solver/direct_solver.h"
#include "incision/solver/iterative_solver.h"

namespace incision {

/// Factorises some groups of pieces and iterates on the others. Groups do not touch each other's unknowns, so each
/// solver leaves out the other's copies. Factorised are those on which an iteration does worst:
/// - small ones: fragments much thinner than their elements are beyond float, and they cost next to nothing;
/// - free ones so stiff that a float matrix has no digits left for their mass, which alone resists a rigid motion.
class PiecewiseSolver : public LinearSolver {
 public:
  /// Groups of up to `direct_up_to` free copies are factorised.
  explicit PiecewiseSolver(int direct_up_to) : direct_up_to_(direct_up_to) {}

  void systemChanged(const Assembly& assembly, const SystemChange& change, const SystemFactors& factors) override;
  void matrixChanged(const std::vector<Vec3>& x) override;
  bool springsChanged(const std::vector<Spring>& springs, double time_step) override;
  void keep(SolverMemory* memory) const override;
  void recall(const SolverMemory& memory) override;
  int correct(const std::vector<Vec3>& r, const SolveDemand& demand, const Basis* basis, std::vector<Vec3>* d,
              std::vector<Vec3>* left) override;
  bool isDirect() const override { return !any_iterative_; }

 private:
  std::vector<bool> directGroups(const Assembly& assembly, const SystemChange& change,
                                 const SystemFactors& factors) const;

  int direct_up_to_;
  bool any_direct_ = false, any_iterative_ = false;
  DirectSolver direct_;
  IterativeSolver iterative_;
};

}  // namespace incision
