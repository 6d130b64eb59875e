#pragma once

#include <vector>

#include "incision/fem/assembly.h"
#include "incision/fem/tension_scheme.h"

namespace incision {

/// The stiffness of tension, K_σ = Σ_p V_p (b_I · S⁺ b_J) 1 with the positive part S⁺ of the part's stress in its own
/// axes. The forces of a warped step turn with a part only once it has turned, and what hangs is swayed up where its
/// pull does more in a step than its mass and its stiffness together, Δt² K_σ > 4 M + Δt² K. Bent in waves of length
/// 2π/k a beam of height h under tension has σ k² > 4 ρ/Δt² + E h² k⁴/12, which no k fulfils unless Δt σ > 1.15 h √(E
/// ρ). K_σ resists such a turn as the tension does. It also slows down what would not sway up, so by itself it acts
/// only in pieces of which Δt σ / (h √(E ρ)) has a mean above 1/2, σ being the largest tension of a part and h the
/// least thickness of the piece: what hangs is pulled twice the mean where it is held. It also does where σ/E has a
/// mean above
/// 1. It would damp what spins, so it acts in held pieces alone. Without warping there is none.
class Tension {
 public:
  /// `assembly` must outlive this.
  explicit Tension(const Assembly& assembly);

  /// `piece` and `held` are of each copy, negative where it is not held. Before use and after every cut.
  void topologyChanged(const std::vector<int>& piece, int pieces, const std::vector<int>& held);

  /// Finds Δt² K_σ of a body at `x` [m], where the assembly has its rotations. Time step in s.
  void find(TensionScheme scheme, double time_step, const std::vector<Vec3>& x);

  /// Whether what was found last is not zero.
  bool acts() const { return acts_; }

  /// Whether it does in the piece of this part.
  bool actsIn(int part) const { return acts_ && part_acts_[part]; }

  /// What was found last for a part, of a body in which it acts.
  const TensionProducts& products(int part) const { return products_[part]; }

  /// Δt² K_σ w [kg × the unit of w] at every copy.
  void multiply(const std::vector<Vec3>& w, std::vector<Vec3>* result) const {
    assembly_.multiplyTension(products_, w, result);
  }

 private:
  void findThickness(const std::vector<int>& piece);
  void choosePieces(double time_step, const std::vector<Vec3>& x);

  struct Mean {
    double sum = 0;
    int count = 0;
  };

  const Assembly& assembly_;
  std::vector<double> impedance_;        // of each element: √(E ρ) [Pa s/m]
  std::vector<double> piece_thickness_;  // at rest [m]
  std::vector<int> part_piece_;          // of each part; −1: it is free
  std::vector<char> piece_held_, piece_acts_, part_acts_;
  bool any_held_ = false, acts_ = false;
  std::vector<TensionProducts> products_;
  // Scratch of the search:
  std::vector<double> pulls_;  // of each part that is looked at
  std::vector<Mean> means_;    // of each piece
};

}  // namespace incision
