#pragma once

#include <array>

#include "incision/base/disjoint_sets.h"
#include "incision/solver/coarse_space.h"
#include "incision/solver/linear_solver.h"

namespace incision {

/// Conjugate gradients on a float matrix of 3×3 blocks, scaled to a unit diagonal, with block Jacobi and an additive
/// coarse space of rigid modes as preconditioner. Pieces between which springs act are iterated together, others each
/// for itself, and only as long as they need.
class IterativeSolver : public LinearSolver {
 public:
  void systemChanged(const Assembly& assembly, const SystemChange& change, const SystemFactors& factors) override;
  void matrixChanged(const std::vector<Vec3>& x) override;
  bool springsChanged(const std::vector<Spring>& springs, double time_step) override;
  void keep(SolverMemory* memory) const override { memory->coarse_blocks = coarse_.springBlocks(); }
  void recall(const SolverMemory& memory) override { coarse_.recallSpringBlocks(memory.coarse_blocks); }
  int correct(const std::vector<Vec3>& r, const SolveDemand& demand, const Basis* basis, std::vector<Vec3>* d,
              std::vector<Vec3>* left) override;
  bool isDirect() const override { return false; }

 private:
  /// The scalars of one group's iteration.
  struct Group {
    double rz = 0, next_rz = 0, pAp = 0;
    float alpha = 0, beta = 0;
    double least = 0;  // of |r|², beyond which floats end
    bool goes_on = false, is_above = false;
  };

  void findGroups();
  void stretchSprings(const std::vector<Vec4f>& p);
  void invertDiagonal(int row, const Mat3& coupled);
  double scaleResidual(const std::vector<Vec3>& r);
  void findActive(const std::vector<double>& limit, double unit);
  void guess(const Basis& basis);
  int iterate(const std::vector<double>& limit, double unit, int most);
  void balance();
  void precondition();
  void findDirections(bool first);
  void multiply();
  void advance();
  void stopGroups();
  double squareOf(int aggregate) const;
  void sumPieces();
  void sumByGroup(double Group::*sum);

  const Assembly* assembly_ = nullptr;
  SystemFactors factors_{};
  NodeOrder order_;  // of the mesh at rest, for good
  BlockPattern pattern_;
  Aggregates aggregates_;
  std::vector<double> scale_;  // 1/√d of each row, d = trace(A_ii)/3
  std::vector<Vec3> rest_x_;   // of each copy, where nothing is warped [m]
  BlockAssembler<float> assembler_;
  std::vector<float> blocks_;
  std::vector<Eigen::Matrix<float, 4, 3>> inverse_diagonal_;
  CoarseSpace coarse_;
  CoupledRows coupled_;

  // Vectors of the iteration, by row, in the scaled unknowns; their fourth entries are padding.
  std::vector<Vec4f> y_, r_, z_, p_, Ap_;
  std::array<std::vector<Vec4f>, BASIS_SIZE> basis_;

  struct BasisProducts {
    BasisMatrix G = BasisMatrix::Zero();
    BasisVector h = BasisVector::Zero();  // then the combination
  };
  std::vector<BasisProducts> products_, combinations_;  // of each aggregate, and of each group

  std::vector<int> piece_of_, group_of_;  // of each aggregate
  int pieces_ = 0;
  DisjointSets piece_sets_;
  std::vector<Group> groups_;             // by their lowest piece
  std::vector<double> piece_sum_, aims_;  // |r|² of each piece, and what it shall be
  std::vector<double> terms_;             // of each aggregate
  std::vector<int> active_;               // aggregates of the groups that go on
};

}  // namespace incision
