#pragma once

#include <functional>
#include <memory>
#include <vector>

#include "incision/fem/block_matrix.h"
#include "incision/solver/settings.h"

namespace incision {

/// What a solve took.
struct SolveStats {
  int iterations = 0;  ///< 0 for a direct solve
  /// ‖r‖/‖b‖ in the norm scaled by the diagonal of A, r reckoned in double from the forces; the worst piece's, as
  /// PieceNorms measures it.
  double residual = 0;
  bool converged = true;
};

/// The right-hand side less A Δv, at every copy, for a trial Δv at every copy; entries of held copies are ignored.
using Residual = std::function<void(const std::vector<Vec3>& dv, std::vector<Vec3>* r)>;

/// Solves A Δv = b, A = mass M + stiffness K, for the free copies.
class LinearSolver {
 public:
  virtual ~LinearSolver() = default;

  /// After a cut, or when copies become held or free. `held` tells of each copy whether it is; `piece` numbers the
  /// pieces; `assembly` must outlive the solver.
  virtual void topologyChanged(const Assembly& assembly, const std::vector<bool>& held, const std::vector<int>& piece,
                               const SystemFactors& factors) = 0;

  /// After the rotations changed; `x` are the copies' positions [m]. Returns false when A is not positive definite.
  virtual bool matrixChanged(const std::vector<Vec3>& x) = 0;

  /// Improves `dv`, which comes with the held copies' values and a guess at the others. `rounding` bounds what rounding
  /// does to the residual at each copy.
  virtual SolveStats solve(const Residual& residual, const std::vector<double>& rounding, std::vector<Vec3>* dv) = 0;
};

/// ‖r‖/‖b‖ piece by piece, over the free copies. A piece at rest is measured by its mass's share of the whole, and none
/// below its rounding: so no small piece is left unsolved, and none is asked for more digits than there are.
class PieceNorms {
 public:
  /// `rows`: the free copies in the solver's order; `diagonal`: of A, by copy.
  void topologyChanged(const Assembly& assembly, const std::vector<int>& rows, const std::vector<int>& piece,
                       const std::vector<double>& diagonal);

  /// Takes the measure of each piece from b, the residual at Δv = 0, scaled by 1/√diagonal, by row.
  void setRightHandSide(const std::vector<Vec3>& b, const std::vector<double>& rounding, double tolerance);

  /// The largest ‖r‖/‖b‖ over the pieces, of r scaled as b was.
  double worstRatio(const std::vector<Vec3>& r);

  /// √Σ‖b‖² over the pieces.
  double total() const { return total_; }

 private:
  std::vector<int> rows_, piece_;         // copy and piece of each row
  std::vector<double> inverse_diagonal_;  // of each row
  std::vector<double> mass_;              // of each piece [kg]
  std::vector<double> measure_, sum_;     // squared, of each piece
  double total_ = 0;
};

std::unique_ptr<LinearSolver> makeLinearSolver(const SolverSettings& settings);

}  // namespace incision
