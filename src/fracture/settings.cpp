#include "incision/fracture/settings.h"

#include <cmath>

#include "incision/base/input_error.h"
#include "incision/base/yaml_reader.h"

namespace incision {

namespace {

bool isFinite(const std::optional<double>& strength) { return strength && !std::isinf(*strength); }

void checkStrengths(const FractureSettings& fracture, const std::vector<RegionSettings>& regions,
                    const YamlValue& value) {
  bool breaks = !std::isinf(fracture.tensile_strength) || !std::isinf(fracture.compressive_strength);
  for (const RegionSettings& region : regions) {
    breaks = breaks || isFinite(region.tensile_strength) || isFinite(region.compressive_strength);
    if (region.fracture_energy && std::isinf(region.tensile_strength.value_or(fracture.tensile_strength)))
      throw InputError(region.place.said_at + ".fracture_energy: needs a tensile_strength, here or of the body");
  }
  if (!breaks)
    value.fail("needs a tensile_strength or a compressive_strength (allowed: above 0 Pa, one of them finite)");
}

}  // namespace

FractureSettings parseFracture(const YamlValue& value, const std::vector<RegionSettings>& regions) {
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
  checkStrengths(fracture, regions, value);
  return fracture;
}

}  // namespace incision
