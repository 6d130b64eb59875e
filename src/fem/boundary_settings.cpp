#include "incision/fem/boundary_settings.h"

#include "incision/base/yaml_reader.h"

namespace incision {

bool moveAlike(const Clamp& a, const Clamp& b) {
  return a.velocity == b.velocity && a.frame == b.frame && a.poses == b.poses;
}

Clamp parseClamp(const YamlValue& value) {
  const YamlMap map = value.map({"group", "box", "velocity", "frame", "poses", "poses_file"});
  Clamp clamp;
  clamp.place = parsePlace(map);
  if (const auto frame = map.find("frame")) clamp.frame = frame->frame();
  parsePosesOf(map, &clamp.poses, &clamp.poses_file);
  const bool posed = clamp.isPosed() || !clamp.poses_file.empty();
  if (posed && map.has("velocity")) map.at("velocity").fail("beside a frame or poses (allowed: one of the two)");
  clamp.velocity = map.vector("velocity", clamp.velocity);
  return clamp;
}

Load parseLoad(const YamlValue& value) {
  const YamlMap map = value.map({"group", "box", "traction", "pressure", "ramp"});
  Load load;
  load.place = parsePlace(map);
  if (!map.has("traction") && !map.has("pressure")) value.fail("needs a traction or a pressure");
  load.traction = map.vector("traction", load.traction);
  load.pressure = map.number("pressure", load.pressure);
  load.ramp = map.number("ramp", load.ramp, SIMULATED_TIME);
  return load;
}

}  // namespace incision
