#pragma once

#include "incision/base/range.h"

namespace incision {

class YamlValue;

/// Lamé's constants [Pa].
struct Lame {
  double lambda, mu;
};

/// Linear isotropic tissue with Rayleigh damping C = α M + β K.
struct Material {
  /// Softer or harder than this [Pa] is a slip of units: rubber foam is 1e4 Pa, diamond 1e12 Pa.
  static constexpr Range YOUNG_MODULUS = {1e-3, 1e15};
  /// Beyond 0.4999 the material is incompressible for all that linear tetrahedra can show, and the bulk modulus, which
  /// grows as 1 / (1 − 2ν), spoils the solver's conditioning.
  static constexpr Range POISSON_RATIO = {0, 0.4999};

  double young_modulus = 1e6;    ///< E [Pa], in YOUNG_MODULUS; default: firm tissue
  double poisson_ratio = 0.45;   ///< ν, in POISSON_RATIO
  double density = 1000;         ///< ρ [kg/m³], > 0
  double mass_damping = 0;       ///< α [1/s], ≥ 0
  double stiffness_damping = 0;  ///< β [s], ≥ 0

  /// Lamé's constants [Pa].
  double lambda() const { return young_modulus * poisson_ratio / ((1 + poisson_ratio) * (1 - 2 * poisson_ratio)); }
  double mu() const { return young_modulus / (2 * (1 + poisson_ratio)); }
  Lame lame() const { return {lambda(), mu()}; }
};

/// Throws InputError.
Material parseMaterial(const YamlValue& value);

}  // namespace incision
