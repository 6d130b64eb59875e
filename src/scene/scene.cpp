#include "incision/scene/scene.h"

#include <functional>

#include "incision/base/input_error.h"
#include "incision/base/yaml_reader.h"

namespace incision {

namespace {

struct Section {
  std::string key;
  bool needed;
  std::function<void(const YamlValue& value, Scene* scene)> read;
};

// Reads a section that is one member of the scene.
template <class Member, class Settings>
auto one(Member Scene::*member, Settings (*parse)(const YamlValue&)) {
  return [=](const YamlValue& value, Scene* scene) { scene->*member = parse(value); };
}

// Reads a section that is a list, each entry by itself.
template <class Entry>
auto each(std::vector<Entry> Scene::*member, Entry (*parse)(const YamlValue&)) {
  return [=](const YamlValue& value, Scene* scene) {
    for (const YamlValue& entry : value.list()) (scene->*member).push_back(parse(entry));
  };
}

Vec3 parseVector(const YamlValue& value) { return value.vector(); }

// All that a scene may hold, in the order in which it is read.
const std::vector<Section>& sections() {
  static const std::vector<Section> all = {
      {"body", true, one(&Scene::body, parseBody)},
      {"gravity", false, one(&Scene::gravity, parseVector)},
      {"boundary", false, each(&Scene::boundary, parseClamp)},
      {"loads", false, each(&Scene::loads, parseLoad)},
      {"solver", false, one(&Scene::solver, parseSolver)},
      {"cuts", false, each(&Scene::cuts, parseCut)},
      {"fracture", false,
       [](const YamlValue& value, Scene* scene) { scene->fracture = parseFracture(value, scene->body.regions); }},
      {"contact", false, one(&Scene::contact, parseContact)},
      {"tools", false, one(&Scene::tools, parseTools)},
  };
  return all;
}

// A strength must not be given in vain.
void checkRegions(const Scene& scene) {
  if (scene.fracture) return;
  for (const RegionSettings& region : scene.body.regions)
    if (region.tensile_strength || region.compressive_strength || region.fracture_energy)
      throw InputError(region.place.said_at + ": a strength or a fracture_energy needs the section fracture");
}

Scene parseSections(const YamlValue& root) {
  std::vector<std::string> keys;
  for (const Section& section : sections()) keys.push_back(section.key);
  const YamlMap map = root.map(keys);
  Scene scene;
  for (const Section& section : sections()) {
    if (section.needed || map.has(section.key)) section.read(map.at(section.key), &scene);
  }
  checkRegions(scene);
  return scene;
}

}  // namespace

Scene parseScene(const YAML::Node& root, const std::string& source, const std::string& folder) {
  try {
    return parseSections(YamlValue(root, source, folder));
  } catch (const YAML::Exception& error) {
    throw InputError(source + ": " + error.what());
  }
}

}  // namespace incision
