#include <gtest/gtest.h>
#include <unistd.h>

#include <cstdio>
#include <fstream>
#include <string>

#include "incision/base/input_error.h"
#include "incision/base/read_text.h"
#include "incision/base/resolve_path.h"
#include "incision/scene/scene.h"

namespace incision {
namespace {

// Smallest scene, to which a test adds its sections.
const std::string GRID_BODY = "body: {grid: {cells: [1, 2, 3]}}\n";

// A file that lives as long as the test.
class SceneFile {
 public:
  explicit SceneFile(const std::string& text, const std::string& name = "scene.yaml")
      : path_(::testing::TempDir() + std::to_string(getpid()) + "_" + name) {
    std::ofstream(path_, std::ios::binary) << text;
  }
  ~SceneFile() { std::remove(path_.c_str()); }
  const std::string& path() const { return path_; }

 private:
  std::string path_;
};

std::string fileComplaint(const std::string& text, const std::vector<std::string>& overrides = {}) {
  const SceneFile file(text);
  try {
    loadScene(file.path(), overrides);
    return "";
  } catch (const InputError& error) {
    return error.what();
  }
}

TEST(SceneFile, JsonIsYamlToo) {
  const SceneFile file(R"({"body": {"grid": {"cells": [1, 1, 1]}}, "gravity": [0, 0, -1.5]})", "scene.json");
  EXPECT_EQ(loadScene(file.path()).gravity, Vec3(0, 0, -1.5));
}

TEST(SceneFile, OverridesReplaceAndAdd) {
  const SceneFile file(GRID_BODY + "cuts: [{normal: [0, 1, 0]}]\n");
  const Scene scene =
      loadScene(file.path(), {"solver.time_step=0.005", "solver.time_step=0.002", "cuts.0.normal=[1,0,0]",
                              "cuts.1={normal: [0, 0, 1]}", "body.grid.size=[2, 2, 2]"});
  EXPECT_EQ(scene.solver.time_step, 0.002);
  ASSERT_EQ(scene.cuts.size(), 2u);
  EXPECT_EQ(scene.cuts[0].plane.normal, Vec3(1, 0, 0));
  EXPECT_EQ(scene.cuts[1].plane.normal, Vec3(0, 0, 1));
  EXPECT_EQ(scene.body.grid->size, Vec3(2, 2, 2));
  EXPECT_EQ(scene.body.grid->cells[1], 2);
}

TEST(SceneFile, MalformedOverridesAreRefused) {
  for (const char* bad :
       {"", "=", "solver", "=1", ".a=1", "a.=1", "a..b=1", "cuts.5.normal=[1,0,0]", "cuts.x=1", "gravity.-1=1",
        "solver.time_step.x=1", "solver.time_step=[", "solver.tim_step=1", "solver.time_step=fast",
        "solver={time_step: 0.1, time_step: 0.2}", "a\n=1", "body.grid.cells="}) {
    const std::string message = fileComplaint(GRID_BODY + "cuts: []\nsolver: {time_step: 0.1}\n", {bad});
    EXPECT_FALSE(message.empty()) << bad;
    EXPECT_EQ(message.find('\n'), std::string::npos) << message;
  }
}

TEST(SceneFile, SyntaxErrorsNameLineAndColumn) {
  EXPECT_NE(fileComplaint("body:\n  grid: [1, 2\n").find("scene.yaml:3:1: "), std::string::npos)
      << fileComplaint("body:\n  grid: [1, 2\n");
}

TEST(SceneFile, HostileTextIsRefused) {
  std::string binary(4096, '\0');
  for (std::size_t i = 0; i < binary.size(); ++i) binary[i] = static_cast<char>(i * 37 % 256);
  for (const std::string& text : {std::string(), std::string("just words"), std::string("- a\n- b\n"), binary,
                                  std::string(100000, '['), std::string(MAX_TEXT + 1, ' ')}) {
    EXPECT_FALSE(fileComplaint(text).empty()) << text.substr(0, 40);
  }
  std::string nested;
  for (int i = 0; i < 50000; ++i) nested += "{a: ";
  EXPECT_NE(fileComplaint("body: " + nested), "");
}

TEST(SceneFile, AliasesThatMultiplyEndAtTheFirstWrongValue) {
  std::string bomb = "a0: &a0 [1, 1, 1, 1, 1, 1, 1, 1, 1, 1]\n";
  for (int i = 1; i < 30; ++i) {
    const std::string before = "*a" + std::to_string(i - 1), name = "a" + std::to_string(i);
    bomb += name + ": &" + name + " [" + before + ", " + before + ", " + before + "]\n";
  }
  EXPECT_NE(fileComplaint(bomb + "body: {grid: {cells: *a29}}"), "");
  EXPECT_NE(fileComplaint("body: &b {grid: *b}"), "");
}

TEST(SceneFile, MissingFilesAndFoldersAreRefused) {
  EXPECT_THROW(loadScene("/no/such/scene.yaml"), InputError);
  EXPECT_THROW(loadScene(::testing::TempDir()), InputError);
}

TEST(SceneFile, ShippedScenesLoad) {
  for (const char* name : {"demo", "bar", "movement_independence", "crossing_cuts", "animal", "slit_plane",
                           "dropped_plate", "thrown_figure", "liver"}) {
    const std::string address = std::string("package://incision/config/scenes/") + name + ".yaml";
    const Scene scene = loadScene(resolvePath(address, ""));
    EXPECT_GT(loadMesh(scene).elements.size(), 0u) << name;
  }
}

}  // namespace
}  // namespace incision
