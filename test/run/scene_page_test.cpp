// The defaults in the table of scene keys in config/README.md, held against what a scene is without them.
#include <gtest/gtest.h>

#include <regex>
#include <string>
#include <vector>

#include "incision/run/scene_key.h"
#include "incision/scene/scene.h"
#include "support/scene_table.h"

namespace incision {
namespace {

const std::string FOLDER = INCISION_SOURCE_DIR;

// Every section, with no more than it needs.
const std::vector<std::string> SECTIONS = {
    "boundary=[{box: [[-1, -1, -1], [2, 2, 1.0e-6]]}]",
    "loads=[{box: [[-1, -1, 0.2], [2, 2, 2]], pressure: 10}]",
    "cuts=[{normal: [0, 0, 1]}]",
    "fracture={tensile_strength: 1.0e5}",
    "contact={ground: 0}",
    "tools={BLADE: {type: blade, description: " + FOLDER +
        "/config/scalpel.urdf, link: blade}, SCISSORS: {type: scissors, " + "description: " + FOLDER +
        "/config/forceps.urdf, link: palm, joint: jaw}, GRASPER: {type: grasper, description: " + FOLDER +
        "/config/forceps.urdf, link: palm, joint: jaw, closed: 0.1, grip: 1}}"};

SceneKey keyWith(const std::string& bare, const std::string& setting) {
  std::vector<std::string> settings = SECTIONS;
  if (!setting.empty()) settings.push_back(setting);
  const Scene scene = loadScene(FOLDER + "/test/run/" + bare, settings);
  const Descriptions descriptions = loadDescriptions(scene);
  return keyOf(DeformableBody(scene, loadMesh(scene), descriptions), descriptions);
}

bool operator==(const SceneKey& a, const SceneKey& b) { return a.scene == b.scene && a.mesh == b.mesh; }

// As a scene takes it; empty where the table says it in words.
std::string valueOf(const std::string& cell) {
  std::smatch word;
  if (std::regex_match(cell, word, std::regex("`([a-z]+)`"))) return word[1];
  return std::regex_match(cell, std::regex(R"([-\d.e]+|\.inf|true|false|\[[-\d., e]+\])")) ? cell : "";
}

TEST(ScenePage, GivesTheDefaults) {
  int checked = 0;
  for (SceneRow row : sceneRows(FOLDER)) {
    const std::string value = valueOf(row.standard);
    // Results do not depend on threads, so a scene counts as the same with any number. Without a strength there is no
    // fracture.
    if (value.empty() || row.key == "solver.threads" || row.key == "fracture.tensile_strength") continue;
    row.key = std::regex_replace(row.key, std::regex("tools\\.NAME"), "tools.BLADE");
    const bool of_mesh = row.key.rfind("body.scale", 0) == 0 || row.key.rfind("body.meshes", 0) == 0;
    const std::string bare = !of_mesh ? "bare.yaml" : row.key == "body.scale" ? "bare_mesh.yaml" : "bare_meshes.yaml";
    EXPECT_TRUE(keyWith(bare, row.key + "=" + value) == keyWith(bare, "")) << row.key << ": " << value;
    ++checked;
  }
  EXPECT_GT(checked, 30);
}

TEST(ScenePage, NoticesADefaultThatIsAnother) {
  EXPECT_FALSE(keyWith("bare.yaml", "contact.friction=0.31") == keyWith("bare.yaml", ""));
  EXPECT_FALSE(keyWith("bare.yaml", "body.grid.size=[1,1,1.01]") == keyWith("bare.yaml", ""));
}

}  // namespace
}  // namespace incision
