#include "incision/fem/boundary_settings.h"

#include "incision/base/yaml_reader.h"

namespace incision {

Clamp parseClamp(const YamlValue& value) {
  const YamlMap map = value.map({"group", "box", "velocity"});
  Clamp clamp;
  clamp.place = parsePlace(map);
  clamp.velocity = map.vector("velocity", clamp.velocity);
  return clamp;
}

Load parseLoad(const YamlValue& value) {
  const YamlMap map = value.map({"group", "box", "traction", "ramp"});
  Load load;
  load.place = parsePlace(map);
  load.traction = map.at("traction").vector();
  load.ramp = map.number("ramp", load.ramp, SIMULATED_TIME);
  return load;
}

}  // namespace incision
