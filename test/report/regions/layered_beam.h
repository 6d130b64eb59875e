#pragma once

#include <vector>

namespace incision::report {

/// Between two heights of a section, of one material without lateral contraction.
struct Layer {
  double bottom, top;    ///< [m]
  double young_modulus;  ///< [Pa]
};

/// A beam of layers from the lowest to the highest, as stiff as their transformed section.
class LayeredBeam {
 public:
  LayeredBeam(const std::vector<Layer>& layers, double width);

  /// Of the end of a cantilever under a force there [m].
  double deflection(double force, double length) const { return bending(force, length) + shear(force, length); }
  /// F L³ / 3 Σ E_k I_k, about the common neutral axis.
  double bending(double force, double length) const { return force * length * length * length / (3 * stiffness_); }
  /// F L ∫ τ²/G dA, τ being the stress [Pa] of a unit of shear force that balances the bending stress. In a section of
  /// one material it is F L / κGA with κ = 5/6.
  double shear(double force, double length) const { return force * length * shear_; }

  /// Which share of a shear force each layer takes.
  const std::vector<double>& shares() const { return shares_; }

 private:
  double neutral_ = 0, stiffness_ = 0, shear_ = 0;  // [m], Σ E_k I_k [N m²], [1/N]
  std::vector<double> shares_;
};

}  // namespace incision::report
