#include "incision/fem/material.h"

#include "incision/base/yaml_reader.h"

namespace incision {

Material parseMaterial(const YamlValue& value) {
  const YamlMap map = value.map({"young_modulus", "poisson_ratio", "density", "mass_damping", "stiffness_damping"});
  Material material;
  material.young_modulus = map.number("young_modulus", material.young_modulus, Material::YOUNG_MODULUS);
  material.poisson_ratio = map.number("poisson_ratio", material.poisson_ratio, Material::POISSON_RATIO);
  material.density = map.number("density", material.density, POSITIVE);
  material.mass_damping = map.number("mass_damping", material.mass_damping, NOT_NEGATIVE);
  material.stiffness_damping = map.number("stiffness_damping", material.stiffness_damping, NOT_NEGATIVE);
  return material;
}

}  // namespace incision
