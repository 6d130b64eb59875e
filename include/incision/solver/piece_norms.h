#pragma once

#include <vector>

#include "incision/fem/block_matrix.h"

namespace incision {

/// How much is left to solve, piece by piece, over the free copies, in the norm scaled by the diagonal of A. Each piece
/// is measured by what acts on it. A piece on which little acts is measured by its mass's share of the whole, and none
/// below its rounding: so no small piece is left unsolved, and none is asked for more digits than there are.
class PieceNorms {
 public:
  /// `held`: the clamp of each copy or −1; `piece` of each copy.
  void systemChanged(const Assembly& assembly, const SystemFactors& factors, const std::vector<int>& held,
                     const std::vector<int>& piece, int pieces);

  /// |values|² of each piece.
  void squares(const std::vector<Vec3>& values, std::vector<double>* sums) const;

  /// Takes the measure of each piece from what acts on it [N s], by copy: the larger of what is left to solve where Δv
  /// = 0, and of the impulse of its weight and loads. What rounding does to the residual is at most `reach` [m s], Δt
  /// times the largest coordinate, times the assembly's bound.
  void measure(const std::vector<Vec3>& b, const std::vector<Vec3>& loads, double reach, double tolerance);
  /// Makes the measure at least that of these impulses.
  void raise(const std::vector<Vec3>& impulses);

  /// |measure|² of each piece.
  const std::vector<double>& measures() const { return measure_; }

  /// The largest |r| among the pieces, over a measure.
  struct Ratio {
    double of_measure = 0;
    /// Over what acts: under loads and weight so small that rounding hides them this is more.
    double of_loads = 0;
  };
  Ratio worstRatio(const std::vector<Vec3>& r);

  /// Whether a float matrix would leave more rounding in A Δv than the tolerance allows.
  bool floatIsTooCoarse(const std::vector<Vec3>& dv, double tolerance) const;

 private:
  double worstOver(const std::vector<double>& measure) const;

  std::vector<int> piece_;             // of each copy
  std::vector<double> squared_scale_;  // 1/diagonal of each copy; 0: it is held
  std::vector<double> mass_;           // of each piece's free copies [kg]
  std::vector<double> rounding_;       // squared, of each piece [N/m]
  std::vector<double> measure_, sum_;  // squared, of each piece
  std::vector<double> acts_;           // squared: the measure before its rounding, where weight or loads act
};

}  // namespace incision
