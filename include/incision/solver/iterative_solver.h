#pragma once

#include <array>

#include "incision/solver/coarse_space.h"
#include "incision/solver/linear_solver.h"
#include "incision/solver/piece_norms.h"

namespace incision {

/// Conjugate gradients on a float matrix of 3×3 blocks, scaled to a unit diagonal, with block Jacobi and an additive
/// coarse space of rigid modes as preconditioner. The residual is reckoned in double from the forces, and the iteration
/// restarted from it, until that is small enough.
class IterativeSolver : public LinearSolver {
 public:
  explicit IterativeSolver(double tolerance) : tolerance_(tolerance) {}

  void systemChanged(const Assembly& assembly, const SystemChange& change, const SystemFactors& factors) override;
  void matrixChanged(const std::vector<Vec3>& x) override;
  bool springsChanged(const std::vector<Spring>& springs, double time_step) override;
  void keep(SolverMemory* memory) const override { memory->coarse_blocks = coarse_.springBlocks(); }
  void recall(const SolverMemory& memory) override { coarse_.recallSpringBlocks(memory.coarse_blocks); }
  SolveStats solve(const Residual& residual, const std::vector<double>& rounding, const Basis& basis,
                   std::vector<Vec3>* dv) override;

 private:
  bool floatIsTooCoarse(const std::vector<Vec3>& dv);
  void stretchSprings(const std::vector<Vec4f>& p);
  void invertDiagonal(int row, const Mat3& coupled);
  void scaleResidual();
  void guess(const Basis& basis);
  int iterate(double target);
  double precondition();
  double update(double alpha);

  double tolerance_;
  const Assembly* assembly_ = nullptr;
  SystemFactors factors_{};
  NodeOrder order_;  // of the mesh at rest, for good
  BlockPattern pattern_;
  Aggregates aggregates_;
  std::vector<double> scale_;  // 1/√d of each row, d = trace(A_ii)/3
  std::vector<Vec3> rest_x_;   // of each copy, where nothing is warped [m]
  PieceNorms norms_;
  BlockAssembler<float> assembler_;
  std::vector<float> blocks_;
  std::vector<Eigen::Matrix<float, 4, 3>> inverse_diagonal_;
  CoarseSpace coarse_;
  CoupledRows coupled_;

  std::vector<Vec3> residual_;  // by copy
  // Vectors of the iteration, by row, in the scaled unknowns over ‖b‖; their fourth entries are padding.
  std::vector<Vec4f> y_, r_, z_, p_, Ap_;
  std::array<std::vector<Vec4f>, BASIS_SIZE> basis_;
  std::vector<double> terms_;

  struct BasisProducts {
    BasisMatrix G = BasisMatrix::Zero();
    BasisVector h = BasisVector::Zero();  // then the combination
  };
  std::vector<BasisProducts> products_, combinations_;  // of each aggregate, and of each group
  std::vector<int> group_of_;                           // of each aggregate
  int groups_ = 0;
};

}  // namespace incision
