#pragma once

#include <utility>

#include "incision/solver/linear_solver.h"
#include "incision/solver/sparse_cholesky.h"

namespace incision {

/// Factorises A whenever it changes.
class DirectSolver : public LinearSolver {
 public:
  void systemChanged(const Assembly& assembly, const SystemChange& change, const SystemFactors& factors) override;
  void matrixChanged(const std::vector<Vec3>& x) override;
  bool springsChanged(const std::vector<Spring>& springs, double time_step) override;
  void keep(SolverMemory* memory) const override;
  void recall(const SolverMemory& memory) override;
  int correct(const std::vector<Vec3>& r, const SolveDemand& demand, const Basis* basis, std::vector<Vec3>* d,
              std::vector<Vec3>* left) override;
  bool isDirect() const override { return true; }

  /// Blocks that are factorised for springs alone.
  int extraBlocks() const { return static_cast<int>(extra_.size()); }

 private:
  void analyse();
  bool factorise(const std::vector<double>& blocks);
  int blockAt(int row, int column) const;
  void findBlocks(const std::vector<Spring>& springs);

  const Assembly* assembly_ = nullptr;
  SystemFactors factors_{};
  BlockPattern pattern_;
  // Blocks beside the pattern's, row ≤ column, ascending: where springs have been of late.
  std::vector<std::pair<int, int>> extra_;
  std::vector<char> used_;    // of each: by the springs now
  int idle_ = 0;              // factorisations in a row in which less than half of them were used
  std::vector<double> ones_;  // of each row
  std::vector<int> source_;   // of each entry of the lower triangle, in blocks_
  BlockAssembler<double> assembler_;
  std::vector<double> blocks_, coupled_blocks_;  // of the pattern; with the extra ones and the springs
  std::vector<double> values_, b_, solution_;
  SparseCholesky cholesky_;
};

}  // namespace incision
