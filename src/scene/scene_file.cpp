#include <yaml-cpp/depthguard.h>
#include <yaml-cpp/yaml.h>

#include <algorithm>
#include <charconv>
#include <filesystem>

#include "incision/base/input_error.h"
#include "incision/base/printable.h"
#include "incision/base/read_text.h"
#include "incision/mesh/grid_mesh.h"
#include "incision/scene/scene.h"

namespace incision {

namespace {

YAML::Node parseYaml(const std::string& text, const std::string& name) {
  try {
    return YAML::Load(text);
  } catch (const YAML::Exception& error) {
    const bool deep = dynamic_cast<const YAML::DeepRecursion*>(&error) != nullptr;
    throw InputError(name + ":" + std::to_string(error.mark.line + 1) + ":" + std::to_string(error.mark.column + 1) +
                     ": " + (deep ? "nested too deeply" : error.msg) + " (allowed: YAML or JSON)");
  }
}

// The list entry or map value called `name`, made when it is missing.
YAML::Node child(YAML::Node parent, const std::string& name, const std::string& override_text) {
  if (!parent.IsSequence()) {
    if (parent.IsDefined() && !parent.IsNull() && !parent.IsMap()) {
      throw InputError("--set " + override_text + ": " + name + " would lie inside a single value");
    }
    return parent[name];
  }
  std::size_t index = 0;
  const auto [end, error] = std::from_chars(name.data(), name.data() + name.size(), index);
  if (error != std::errc() || end != name.data() + name.size() || index > parent.size()) {
    throw InputError("--set " + override_text + ": '" + name + "' (allowed: an index from 0 to " +
                     std::to_string(parent.size()) + ")");
  }
  if (index == parent.size()) parent.push_back(YAML::Node());
  return parent[index];
}

void applyOverride(const YAML::Node& root, const std::string& override_text) {
  const std::string shown = printable(override_text);
  const std::size_t equals = override_text.find('=');
  const std::string key = override_text.substr(0, equals);
  if (equals == std::string::npos || key.empty() || key.front() == '.' || key.back() == '.' ||
      key.find("..") != std::string::npos) {
    throw InputError("--set " + shown + " (allowed: KEY=VALUE, such as solver.time_step=0.005)");
  }
  YAML::Node place = root;
  for (std::size_t begin = 0; begin <= key.size();) {
    const std::size_t end = std::min(key.find('.', begin), key.size());
    place.reset(child(place, key.substr(begin, end - begin), shown));
    begin = end + 1;
  }
  place = parseYaml(override_text.substr(equals + 1), "--set " + shown);
}

}  // namespace

void loadPoses(Scene* scene) {
  for (Clamp& clamp : scene->boundary)
    if (!clamp.poses_file.empty()) clamp.poses = readPoses(clamp.poses_file);
  for (ToolSettings& tool : scene->tools) {
    if (!tool.poses_file.empty()) tool.poses = readPoses(tool.poses_file);
    if (tool.jaw && !tool.jaw->file.empty()) tool.jaw->angles = readAngles(tool.jaw->file);
  }
}

Scene loadScene(const std::string& path, const std::vector<std::string>& overrides) {
  const std::string name = printable(path);
  const YAML::Node root = parseYaml(readText(path), name);
  if (!root.IsMap()) throw InputError(name + ": not a scene (allowed: a YAML map with the key body)");
  try {
    for (const std::string& text : overrides) applyOverride(root, text);
  } catch (const YAML::Exception& error) {
    throw InputError(name + ": " + error.what());
  }
  Scene scene = parseScene(root, name, std::filesystem::absolute(path).parent_path().string());
  loadPoses(&scene);
  return scene;
}

TetMesh loadMesh(const Scene& scene, std::vector<std::string>* notes) {
  return scene.body.grid ? gridMesh(*scene.body.grid) : readPlacedMeshes(scene.body.meshes, notes);
}

Descriptions loadDescriptions(const Scene& scene) {
  Descriptions texts;
  for (const ToolSettings& tool : scene.tools)
    texts.tools.push_back(tool.description.empty() ? "" : readText(tool.description));
  if (scene.contact && !scene.contact->obstacles.empty()) texts.obstacles = readText(scene.contact->obstacles);
  return texts;
}

}  // namespace incision
