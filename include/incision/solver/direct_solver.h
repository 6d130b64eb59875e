#pragma once

#include "incision/solver/linear_solver.h"
#include "incision/solver/piece_norms.h"
#include "incision/solver/sparse_cholesky.h"

namespace incision {

/// Factorises A whenever it changes.
class DirectSolver : public LinearSolver {
 public:
  void systemChanged(const Assembly& assembly, const SystemChange& change, const SystemFactors& factors) override;
  bool matrixChanged(const std::vector<Vec3>& x) override;
  SolveStats solve(const Residual& residual, const std::vector<double>& rounding, const Basis& basis,
                   std::vector<Vec3>* dv) override;

 private:
  const Assembly* assembly_ = nullptr;
  SystemFactors factors_{};
  BlockPattern pattern_;
  PieceNorms norms_;
  std::vector<double> ones_;  // of each row
  std::vector<int> source_;   // of each entry of the lower triangle, in blocks_
  BlockAssembler<double> assembler_;
  std::vector<double> blocks_, values_, b_, solution_;
  SparseCholesky cholesky_;
  std::vector<Vec3> residual_;  // by copy
};

}  // namespace incision
