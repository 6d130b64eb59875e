#pragma once

#include <vector>

#include "incision/fem/block_matrix.h"

namespace incision {

/// ‖r‖/‖b‖ piece by piece, over the free copies, in the norm scaled by the diagonal of A. A piece at rest is measured
/// by its mass's share of the whole, and none below its rounding: so no small piece is left unsolved, and none is asked
/// for more digits than there are.
class PieceNorms {
 public:
  /// `rows`: the free copies in the solver's order; `piece` of each copy; `scale`: 1/√diagonal of each row.
  void systemChanged(const Assembly& assembly, const std::vector<int>& rows, const std::vector<int>& piece,
                     const std::vector<double>& scale);

  /// Takes the measure of each piece from b, the residual at Δv = 0, by copy.
  void setRightHandSide(const std::vector<Vec3>& b, const std::vector<double>& rounding, double tolerance);

  /// The largest ‖r‖/‖b‖ over the pieces, of the residual r by copy.
  double worstRatio(const std::vector<Vec3>& r);
  /// The largest ‖r‖/‖b‖ over the pieces, of r scaled by 1/√diagonal and by 1/total(), by row.
  double worstRatio(const std::vector<Vec4f>& r);

  /// √Σ‖b‖² over the pieces.
  double total() const { return total_; }

 private:
  double worstSum(double unit) const;

  std::vector<int> rows_, piece_;      // copy and piece of each row
  std::vector<double> squared_scale_;  // of each row
  std::vector<double> mass_;           // of each piece [kg]
  std::vector<double> measure_, sum_;  // squared, of each piece
  double total_ = 0;
};

}  // namespace incision
