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
  SolveStats solve(const Residual& residual, std::vector<Vec3>* dv) override;

 private:
  const Assembly* assembly_ = nullptr;
  SystemFactors factors_{};
  BlockPattern pattern_;
  std::vector<double> ones_, inverse_diagonal_;
  std::vector<int> source_;  // of each entry of the lower triangle, in blocks_
  BlockAssembler<double> assembler_;
  std::vector<double> blocks_, values_, b_, solution_;
  SparseCholesky cholesky_;
  std::vector<Vec3> r_;
};

}  // namespace incision
