#include "incision/fracture/settings.h"

#include <cmath>

#include "incision/base/yaml_reader.h"

namespace incision {

FractureSettings parseFracture(const YamlValue& value) {
  const YamlMap map = value.map(
      {"tensile_strength", "compressive_strength", "crack_speed", "fuse_distance", "fuse_angle", "fracture_energy"});
  FractureSettings fracture;
  fracture.tensile_strength = map.numberOrInfinity("tensile_strength", fracture.tensile_strength, POSITIVE);
  fracture.compressive_strength = map.numberOrInfinity("compressive_strength", fracture.compressive_strength, POSITIVE);
  fracture.crack_speed = map.numberOrInfinity("crack_speed", fracture.crack_speed, POSITIVE);
  fracture.fuse_distance = map.number("fuse_distance", fracture.fuse_distance, NOT_NEGATIVE);
  fracture.fuse_angle = map.number("fuse_angle", fracture.fuse_angle, FractureSettings::FUSE_ANGLE);
  if (const auto energy = map.find("fracture_energy")) {
    if (std::isinf(fracture.tensile_strength)) energy->fail("needs a tensile_strength");
    fracture.fracture_energy = energy->number(POSITIVE);
  }
  if (std::isinf(fracture.tensile_strength) && std::isinf(fracture.compressive_strength)) {
    value.fail("needs a tensile_strength or a compressive_strength (allowed: above 0 Pa, one of them finite)");
  }
  return fracture;
}

}  // namespace incision
