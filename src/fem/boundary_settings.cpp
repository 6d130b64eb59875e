#include "incision/fem/boundary_settings.h"

#include "incision/base/yaml_reader.h"

namespace incision {

Hold parseHold(const YamlValue& value) {
  const YamlMap map = value.map({"box", "velocity"});
  Hold hold;
  hold.box = parseRestBox(map.at("box"));
  hold.velocity = map.vector("velocity", hold.velocity);
  return hold;
}

Load parseLoad(const YamlValue& value) {
  const YamlMap map = value.map({"box", "traction", "ramp"});
  Load load;
  load.box = parseRestBox(map.at("box"));
  load.traction = map.at("traction").vector();
  load.ramp = map.number("ramp", load.ramp, SIMULATED_TIME);
  return load;
}

}  // namespace incision
