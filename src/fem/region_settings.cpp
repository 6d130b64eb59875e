#include "incision/fem/region_settings.h"

#include "incision/base/yaml_reader.h"
#include "incision/fem/material.h"

namespace incision {
namespace {

std::optional<double> number(const YamlMap& map, const std::string& key, const Range& range) {
  const auto value = map.find(key);
  return value ? std::optional<double>(value->number(range)) : std::nullopt;
}

std::optional<double> strength(const YamlMap& map, const std::string& key) {
  const auto value = map.find(key);
  return value ? std::optional<double>(value->numberOrInfinity(POSITIVE)) : std::nullopt;
}

}  // namespace

RegionSettings parseRegion(const YamlValue& value) {
  const YamlMap map = value.map({"group", "box", "material", "tensile_strength", "compressive_strength",
                                 "fracture_energy", "cutting_force", "cutting_viscosity", "cutting_onset"});
  RegionSettings region;
  region.place = parsePlace(map);
  if (const auto given = map.find("material")) {
    const YamlMap material = given->map({"young_modulus", "poisson_ratio", "density"});
    region.young_modulus = number(material, "young_modulus", Material::YOUNG_MODULUS);
    region.poisson_ratio = number(material, "poisson_ratio", Material::POISSON_RATIO);
    region.density = number(material, "density", POSITIVE);
  }
  region.tensile_strength = strength(map, "tensile_strength");
  region.compressive_strength = strength(map, "compressive_strength");
  region.fracture_energy = number(map, "fracture_energy", POSITIVE);
  region.cutting_force = number(map, "cutting_force", NOT_NEGATIVE);
  region.cutting_viscosity = number(map, "cutting_viscosity", NOT_NEGATIVE);
  region.cutting_onset = number(map, "cutting_onset", NOT_NEGATIVE);
  return region;
}

}  // namespace incision
