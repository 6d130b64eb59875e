#pragma once

namespace incision {

/// Linear isotropic tissue with Rayleigh damping C = α M + β K.
struct Material {
  double young_modulus = 1e6;    ///< E [Pa], > 0; default: firm tissue
  double poisson_ratio = 0.45;   ///< ν, in [0, 0.5)
  double density = 1000;         ///< ρ [kg/m³], > 0
  double mass_damping = 0;       ///< α [1/s], ≥ 0
  double stiffness_damping = 0;  ///< β [s], ≥ 0

  /// Lamé's constants [Pa].
  double lambda() const { return young_modulus * poisson_ratio / ((1 + poisson_ratio) * (1 - 2 * poisson_ratio)); }
  double mu() const { return young_modulus / (2 * (1 + poisson_ratio)); }
};

}  // namespace incision
