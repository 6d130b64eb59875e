#pragma once

#include "incision/solver/coarse_space.h"
#include "incision/solver/linear_solver.h"

namespace incision {

/// Conjugate gradients on a float matrix of 3×3 blocks, scaled to a unit diagonal, with block Jacobi and an additive
/// coarse space of rigid modes as preconditioner. The residual is reckoned in double from the forces, and the iteration
/// restarted from it, until that is small enough.
class IterativeSolver : public LinearSolver {
 public:
  explicit IterativeSolver(double tolerance) : tolerance_(tolerance) {}

  void topologyChanged(const Assembly& assembly, const std::vector<bool>& held, const std::vector<int>& piece,
                       const SystemFactors& factors) override;
  bool matrixChanged(const std::vector<Vec3>& x) override;
  SolveStats solve(const Residual& residual, const std::vector<double>& rounding, std::vector<Vec3>* dv) override;

 private:
  void takeResidual(const Residual& residual, const std::vector<Vec3>& dv);
  int iterate(double target);
  double applyPreconditioner();
  template <typename Function>
  double sumOverAggregates(const Function& f);

  double tolerance_;
  const Assembly* assembly_ = nullptr;
  SystemFactors factors_{};
  Aggregates aggregates_;
  BlockPattern pattern_;
  std::vector<double> scale_;  // 1/√d of each row, d = trace(A_ii)/3
  PieceNorms norms_;
  BlockAssembler<float> assembler_;
  std::vector<float> blocks_;
  std::vector<Mat3> inverse_diagonal_;
  CoarseSpace coarse_;

  // Vectors of the iteration, in the scaled unknowns, by row.
  std::vector<Vec3> y_, r_, z_;
  std::vector<Eigen::Vector4f> p_, Ap_;
  std::vector<Vec3> nodal_residual_;        // by copy
  std::vector<double> target_, piece_sum_;  // squared norms of each piece
  std::vector<double> terms_;
};

}  // namespace incision
