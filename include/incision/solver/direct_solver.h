#pragma once

#include "incision/solver/linear_solver.h"
#include "incision/solver/sparse_cholesky.h"

namespace incision {

/// Factorises A whenever it changes.
class DirectSolver : public LinearSolver {
 public:
  void topologyChanged(const Assembly& assembly, const std::vector<bool>& held, const std::vector<int>& piece,
                       const SystemFactors& factors) override;
  bool matrixChanged(const std::vector<Vec3>& x) override;
  SolveStats solve(const Residual& residual, const std::vector<double>& rounding, std::vector<Vec3>* dv) override;

 private:
  void takeResidual(const Residual& residual, const std::vector<Vec3>& dv);

  const Assembly* assembly_ = nullptr;
  SystemFactors factors_{};
  BlockPattern pattern_;
  PieceNorms norms_;
  std::vector<double> ones_, scale_;  // of each row: 1, and 1/√diagonal of A
  std::vector<int> source_;           // of each entry of the lower triangle, in blocks_
  BlockAssembler<double> assembler_;
  std::vector<double> blocks_, values_, b_, solution_;
  SparseCholesky cholesky_;
  std::vector<Vec3> nodal_residual_, r_;  // by copy, and scaled by row
};

}  // namespace incision
