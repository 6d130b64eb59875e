#include "incision/fem/body_settings.h"

#include "incision/base/yaml_reader.h"

namespace incision {

BodySettings parseBody(const YamlValue& value) {
  const YamlMap map =
      value.map({"mesh", "scale", "meshes", "grid", "frame", "material", "regions", "pressure", "warping", "mass"});
  if (map.has("mesh") + map.has("meshes") + map.has("grid") != 1) {
    value.fail("needs a mesh, meshes or a grid (allowed: one of the three)");
  }
  BodySettings body;
  body.meshes = parsePlacedMeshes(map);
  if (const auto grid = map.find("grid")) body.grid = parseGrid(*grid);
  if (const auto frame = map.find("frame")) body.frame = frame->frame();
  if (const auto material = map.find("material")) body.material = parseMaterial(*material);
  for (const YamlValue& region : map.list("regions")) body.regions.push_back(parseRegion(region));
  if (const auto pressure = map.find("pressure")) {
    body.pressure = pressure->choice<Pressure>({{"element", Pressure::ELEMENT}, {"averaged", Pressure::AVERAGED}});
  }
  if (const auto warping = map.find("warping")) body.warping = warping->boolean();
  if (const auto mass = map.find("mass")) {
    body.mass = mass->choice<Mass>({{"lumped", Mass::LUMPED}, {"consistent", Mass::CONSISTENT}});
  }
  return body;
}

}  // namespace incision
