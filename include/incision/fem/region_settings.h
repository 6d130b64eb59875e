#pragma once

#include <optional>
#include <string>

#include "incision/mesh/place.h"

namespace incision {

/// Elements with a tissue of their own. What it does not say is the body's.
struct RegionSettings {
  Place place;
  std::optional<double> young_modulus;  ///< E [Pa], in Material::YOUNG_MODULUS
  std::optional<double> poisson_ratio;  ///< ν, in Material::POISSON_RATIO
  std::optional<double> density;        ///< ρ [kg/m³], > 0

  std::optional<double> tensile_strength;      ///< [Pa], > 0
  std::optional<double> compressive_strength;  ///< [Pa], > 0
  std::optional<double> fracture_energy;       ///< [J/m²], > 0
  std::optional<double> cutting_force;         ///< of any blade in it [N/m], ≥ 0,
  std::optional<double> cutting_viscosity;     ///< likewise [N s/m²], ≥ 0
  std::optional<double> cutting_onset;         ///< likewise [N/m], ≥ 0
};

/// An entry of the list `body.regions`. Throws InputError.
RegionSettings parseRegion(const YamlValue& value);

}  // namespace incision
