#include "incision/scene/scene.h"

#include <gtest/gtest.h>
#include <unistd.h>
#include <yaml-cpp/yaml.h>

#include <cmath>
#include <cstdio>
#include <fstream>
#include <string>

#include "incision/base/input_error.h"
#include "incision/base/read_text.h"
#include "incision/base/resolve_path.h"

namespace incision {
namespace {

// Smallest scene, to which a test adds its sections.
const std::string BODY = "body: {grid: {cells: [1, 2, 3]}}\n";

Scene parse(const std::string& text) { return parseScene(YAML::Load(text), "scene.yaml", "/folder"); }

// What the parser says of a text; empty when it accepts it.
std::string complaint(const std::string& text) {
  try {
    parse(text);
    return "";
  } catch (const InputError& error) {
    return error.what();
  }
}

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

TEST(Scene, EverySectionArrivesInItsSettings) {
  const Scene scene = parse(R"(
body:
  grid: {cells: [16, 4, 2], size: [1, 0.25, 0.5], origin: [-1, 2, 3]}
  frame: liver
  material: {young_modulus: 2e4, poisson_ratio: 0.3, density: 1050, mass_damping: 0.5, stiffness_damping: 0.01}
  pressure: averaged
  warping: false
  mass: consistent
gravity: [1, 2, 3]
boundary:
  - {box: [[-1, -2, -3], [1, 2, 3]], velocity: [4, 5, 6]}
loads:
  - {box: [[0, 0, 0], [1, 1, 1]], traction: [7, 8, 9], ramp: 0.5}
solver: {time_step: 0.005, method: iterative, tolerance: 1.0e-8, threads: 3, integrator: bdf2}
cuts:
  - {time: 0.25, label: first, point: [0.5, 0, 0], normal: [1, 0, 0], tangent: [0, 1, 0], length: 2, width: 3}
contact: {ground: -0.5, obstacles: room.urdf, friction: 0.7, self: false}
tool: {link: blade, edge: [[0, 0, 0], [0, 0, 0.1]], poses: [[0.5, 1, 2, 3, 0, 0, 0, 1], [1, 1, 2, 3, 0, 0, 1, 0]],
       frame: knife, max_step: 0.02, timeout: .inf, cutting_force: 40, friction: 0.1, progressive: false}
)");
  EXPECT_EQ(scene.body.grid->cells, (std::array<int, 3>{16, 4, 2}));
  EXPECT_EQ(scene.body.grid->size, Vec3(1, 0.25, 0.5));
  EXPECT_EQ(scene.body.grid->origin, Vec3(-1, 2, 3));
  EXPECT_EQ(scene.body.frame, "liver");
  EXPECT_EQ(scene.body.material.young_modulus, 2e4);
  EXPECT_EQ(scene.body.material.poisson_ratio, 0.3);
  EXPECT_EQ(scene.body.material.density, 1050);
  EXPECT_EQ(scene.body.material.mass_damping, 0.5);
  EXPECT_EQ(scene.body.material.stiffness_damping, 0.01);
  EXPECT_EQ(scene.body.pressure, Pressure::AVERAGED);
  EXPECT_FALSE(scene.body.warping);
  EXPECT_EQ(scene.body.mass, Mass::CONSISTENT);
  EXPECT_EQ(scene.gravity, Vec3(1, 2, 3));
  ASSERT_EQ(scene.boundary.size(), 1u);
  EXPECT_EQ(scene.boundary[0].box.min, Vec3(-1, -2, -3));
  EXPECT_EQ(scene.boundary[0].box.max, Vec3(1, 2, 3));
  EXPECT_EQ(scene.boundary[0].velocity, Vec3(4, 5, 6));
  ASSERT_EQ(scene.loads.size(), 1u);
  EXPECT_EQ(scene.loads[0].traction, Vec3(7, 8, 9));
  EXPECT_EQ(scene.loads[0].ramp, 0.5);
  EXPECT_EQ(scene.solver.time_step, 0.005);
  EXPECT_EQ(scene.solver.method, Method::ITERATIVE);
  EXPECT_EQ(scene.solver.tolerance, 1e-8);
  EXPECT_EQ(scene.solver.threads, 3);
  EXPECT_EQ(scene.solver.integrator, Integrator::BDF2);
  ASSERT_EQ(scene.cuts.size(), 1u);
  EXPECT_EQ(scene.cuts[0].time, 0.25);
  EXPECT_EQ(scene.cuts[0].plane.label, "first");
  EXPECT_EQ(scene.cuts[0].plane.point, Vec3(0.5, 0, 0));
  EXPECT_EQ(scene.cuts[0].plane.normal, Vec3(1, 0, 0));
  EXPECT_EQ(scene.cuts[0].plane.tangent, Vec3(0, 1, 0));
  EXPECT_EQ(scene.cuts[0].plane.length, 2);
  EXPECT_EQ(scene.cuts[0].plane.width, 3);
  ASSERT_TRUE(scene.contact);
  EXPECT_EQ(scene.contact->ground, -0.5);
  EXPECT_EQ(scene.contact->obstacles, "/folder/room.urdf");
  EXPECT_EQ(scene.contact->friction, 0.7);
  EXPECT_FALSE(scene.contact->self);
  ASSERT_TRUE(scene.tool && scene.tool->edge);
  EXPECT_EQ((*scene.tool->edge)[1], Vec3(0, 0, 0.1));
  ASSERT_EQ(scene.tool->poses.size(), 2u);
  EXPECT_EQ(scene.tool->poses[1].time, 1);
  EXPECT_EQ(scene.tool->poses[1].pose.orientation.z(), 1);
  EXPECT_EQ(scene.tool->frame, "knife");
  EXPECT_EQ(scene.tool->max_step, 0.02);
  EXPECT_TRUE(std::isinf(scene.tool->timeout));
  EXPECT_EQ(scene.tool->cutting_force, 40);
  EXPECT_EQ(scene.tool->friction, 0.1);
  EXPECT_FALSE(scene.tool->progressive);
}

TEST(Scene, WhatIsNotGivenKeepsTheStagesDefault) {
  const Scene scene = parse(BODY + "loads:\nsolver:\ncontact:\n");
  EXPECT_EQ(scene.body.material.young_modulus, Material().young_modulus);
  EXPECT_EQ(scene.solver.time_step, SolverSettings().time_step);
  EXPECT_EQ(scene.gravity, Scene().gravity);
  EXPECT_EQ(scene.body.frame, "body");
  EXPECT_TRUE(scene.boundary.empty() && scene.loads.empty() && scene.cuts.empty());
  ASSERT_TRUE(scene.contact);
  EXPECT_FALSE(scene.contact->ground);
  EXPECT_TRUE(scene.contact->obstacles.empty() && scene.contact->self);
  EXPECT_EQ(scene.contact->friction, ContactSettings().friction);
  EXPECT_FALSE(scene.tool);
}

TEST(Scene, TextThatReadsAsANumberIsANumber) {
  const Scene scene =
      parse("body: {grid: {cells: ['1', 2.0, 3e0]}, material: {young_modulus: '1e6', density: +2.5E2}}");
  EXPECT_EQ(scene.body.grid->cells, (std::array<int, 3>{1, 2, 3}));
  EXPECT_EQ(scene.body.material.young_modulus, 1e6);
  EXPECT_EQ(scene.body.material.density, 250);
}

TEST(Scene, MessagesNameSourceKeyValueAndWhatIsAllowed) {
  EXPECT_EQ(complaint("body: {grid: {cells: [1, 1, 1]}, material: {poisson_ratio: 0.5}}"),
            "scene.yaml: body.material.poisson_ratio: '0.5' (allowed: 0 to 0.4999)");
  EXPECT_EQ(complaint(BODY + "boundary: [{box: [[0, 0, 0], [1, 1]]}]"),
            "scene.yaml: boundary.0.box.1: a list of 2 (allowed: a list of 3)");
  EXPECT_EQ(
      complaint(BODY + "solver: {methd: auto}"),
      "scene.yaml: solver.methd: unknown key, did you mean method? (allowed: time_step, method, tolerance, threads, "
      "integrator)");
  EXPECT_EQ(complaint(BODY + "solver: {method: fast}"),
            "scene.yaml: solver.method: 'fast' (allowed: auto, direct, iterative)");
  EXPECT_EQ(complaint(BODY + "solver: {integrator: fast}"),
            "scene.yaml: solver.integrator: 'fast' (allowed: bdf2, euler)");
}

struct BadScene {
  std::string text, key;
};

// Prints the scene where a test fails.
std::ostream& operator<<(std::ostream& out, const BadScene& bad) { return out << bad.text; }

class RefusedScene : public ::testing::TestWithParam<BadScene> {};

TEST_P(RefusedScene, NamesTheKeyInOneLine) {
  const std::string message = complaint(GetParam().text);
  EXPECT_EQ(message.find("scene.yaml: " + GetParam().key), 0u) << message;
  EXPECT_EQ(message.find('\n'), std::string::npos) << message;
}

BadScene inMaterial(const std::string& entry, const std::string& key) {
  return {"body: {grid: {cells: [1, 1, 1]}, material: {" + entry + "}}", "body.material." + key};
}
BadScene inBody(const std::string& entry, const std::string& key) { return {"body: {" + entry + "}", key}; }
BadScene inScene(const std::string& entry, const std::string& key) { return {BODY + entry, key}; }
BadScene inCut(const std::string& entry, const std::string& key) {
  return inScene("cuts: [{normal: [1, 0, 0], " + entry + "}]", "cuts.0" + key);
}
BadScene inFracture(const std::string& entry, const std::string& key) {
  return inScene("fracture: {" + entry + "}", "fracture." + key);
}
BadScene inTool(const std::string& entry, const std::string& key) {
  return inScene("tool: {link: blade, " + entry + "}", "tool" + key);
}

BadScene inKnife(const std::string& entry, const std::string& key) {
  return inTool("edge: [[0, 0, 0], [0, 0, 1]], " + entry, key);
}

INSTANTIATE_TEST_SUITE_P(
    Values, RefusedScene,
    ::testing::Values(
        inMaterial("young_modulus: 0", "young_modulus"), inMaterial("young_modulus: 1e16", "young_modulus"),
        inMaterial("young_modulus: .nan", "young_modulus"), inMaterial("young_modulus: .inf", "young_modulus"),
        inMaterial("young_modulus: soft", "young_modulus"), inMaterial("young_modulus: 1e6 Pa", "young_modulus"),
        inMaterial("young_modulus: 1e999", "young_modulus"), inMaterial("young_modulus: ''", "young_modulus"),
        inMaterial("young_modulus:", "young_modulus"), inMaterial("young_modulus: [1]", "young_modulus"),
        inMaterial("poisson_ratio: -0.1", "poisson_ratio"), inMaterial("density: 0", "density"),
        inMaterial("mass_damping: -1", "mass_damping"), inMaterial("stiffness_damping: -1", "stiffness_damping"),
        inMaterial("density: 1, density: 2", "density: given twice"), inBody("[1]: 2", "body: a key")));

INSTANTIATE_TEST_SUITE_P(
    Sections, RefusedScene,
    ::testing::Values(BadScene{"{}", "the key body is missing"}, BadScene{"[1, 2]", "a list of 2"},
                      inBody("", "body: needs a mesh or a grid"),
                      inBody("mesh: a.msh, grid: {cells: [1, 1, 1]}", "body: needs a mesh or a grid"),
                      inBody("mesh: ''", "body.mesh"), inBody("mesh: http://host/a.msh", "body.mesh"),
                      inBody("mesh: package://no_such_package/a.msh", "body.mesh: package no_such_package not found"),
                      inBody("grid: {cells: [0, 1, 1]}", "body.grid.cells.0"),
                      inBody("grid: {cells: [1.5, 1, 1]}", "body.grid.cells.0"),
                      inBody("grid: {cells: [1e99, 1, 1]}", "body.grid.cells.0"),
                      inBody("grid: {cells: [1, 1, 1], size: [1, 0, 1]}", "body.grid.size.1"),
                      inBody("grid: {cells: [1, 1, 1]}, frame: /body", "body.frame"),
                      inBody("grid: {cells: [1, 1, 1]}, warping: maybe", "body.warping"),
                      inBody("grid: {cells: [1, 1, 1]}, mass: heavy", "body.mass"),
                      inBody("grid: {cells: [1, 1, 1]}, pressure: high", "body.pressure"),
                      inScene("friction: 0.3", "friction: unknown key"), inScene("gravity: -9.81", "gravity"),
                      inScene("boundary: {box: 1}", "boundary"),
                      inScene("boundary: [{velocity: [0, 0, 0]}]", "boundary.0"),
                      inScene("boundary: [{box: [[0, 0, 1], [1, 1, 0]]}]", "boundary.0.box"),
                      inScene("loads: [{box: [[0, 0, 0], [1, 1, 1]]}]", "loads.0: the key traction is missing"),
                      inScene("loads: [{box: [[0, 0, 0], [1, 1, 1]], traction: [1, 0, 0], ramp: -1}]", "loads.0.ramp"),
                      inScene("solver: {time_step: 0}", "solver.time_step"),
                      inScene("solver: {time_step: 2}", "solver.time_step"),
                      inScene("solver: {tolerance: 1}", "solver.tolerance"),
                      inScene("solver: {threads: 65}", "solver.threads"), inScene("solver: 5", "solver")));

INSTANTIATE_TEST_SUITE_P(
    Fracture, RefusedScene,
    ::testing::Values(inScene("fracture: {}", "fracture: needs a tensile_strength or a compressive_strength"),
                      inScene("fracture: {tensile_strength: .inf}", "fracture: needs a tensile_strength"),
                      inFracture("tensile_strength: 0", "tensile_strength"),
                      inFracture("tensile_strength: -1e5", "tensile_strength"),
                      inFracture("tensile_strength: .nan", "tensile_strength"),
                      inFracture("tensile_strength: strong", "tensile_strength"),
                      inFracture("compressive_strength: -.inf", "compressive_strength"),
                      inFracture("crack_speed: 0", "crack_speed"), inFracture("crack_speed: [1]", "crack_speed"),
                      inFracture("fuse_distance: -1", "fuse_distance"),
                      inFracture("fuse_distance: .inf", "fuse_distance"), inFracture("fuse_angle: 1.6", "fuse_angle"),
                      inFracture("tensile_strength: 1, fracture_energy: 0", "fracture_energy"),
                      inFracture("compressive_strength: 1, fracture_energy: 1", "fracture_energy: needs"),
                      inFracture("toughness: 1", "toughness: unknown key")));

TEST(Scene, FractureArrivesInItsSettings) {
  const Scene scene = parse(BODY +
                            "fracture: {tensile_strength: 1e5, compressive_strength: '.inf', crack_speed: 20, "
                            "fuse_distance: 0.01, fuse_angle: 0.5, fracture_energy: 30}");
  ASSERT_TRUE(scene.fracture);
  EXPECT_EQ(scene.fracture->tensile_strength, 1e5);
  EXPECT_TRUE(std::isinf(scene.fracture->compressive_strength));
  EXPECT_EQ(scene.fracture->crack_speed, 20);
  EXPECT_EQ(scene.fracture->fuse_distance, 0.01);
  EXPECT_EQ(scene.fracture->fuse_angle, 0.5);
  EXPECT_EQ(scene.fracture->fracture_energy, 30);
  EXPECT_FALSE(parse(BODY).fracture);
}

INSTANTIATE_TEST_SUITE_P(
    CutsAndTools, RefusedScene,
    ::testing::Values(
        inScene("cuts: [{point: [0, 0, 0]}]", "cuts.0: the key normal is missing"),
        inScene("cuts: [{normal: [0, 0, 0]}]", "cuts.0: normal"), inCut("time: -1", ".time"),
        inCut("time: 1e300", ".time"), inCut("label: " + std::string(65, 'x'), ".label"),
        inCut("label: \"a\\nb\"", ".label"), inCut("length: -1", ".length"), inCut("width: .inf", ".width"),
        inCut("length: 1, tangent: [2, 0, 0]", ": tangent"), inTool("poses: []", ": needs an edge"),
        inTool("edge: [[0, 0, 0], [0, 0, 0]]", ".edge"), inTool("edge: [[0, 0, 0]]", ".edge"),
        inTool("edge: [[0, 0, 0], [0, 0, 1]], poses: [[0, 0, 0, 0, 0, 0, 1]]", ".poses.0"),
        inTool("edge: [[0, 0, 0], [0, 0, 1]], poses: [[0, 0, 0, 0, 0, 0, 0, 0]]", ".poses.0"),
        inTool("edge: [[0, 0, 0], [0, 0, 1]], poses: [[0, 0, 0, 0, 0, 0, 0, 1], [0, 0, 0, 0, 0, 0, 0, 1]]", ".poses.1"),
        inKnife("frame: /knife", ".frame"), inKnife("max_step: 0", ".max_step"), inKnife("timeout: -1", ".timeout"),
        inKnife("cutting_force: -1", ".cutting_force"), inKnife("cutting_force: .inf", ".cutting_force"),
        inKnife("friction: 11", ".friction"), inKnife("progressive: 0.5", ".progressive"),
        inScene("tool: {description: a.urdf}", "tool: the key link is missing")));

INSTANTIATE_TEST_SUITE_P(
    Contact, RefusedScene,
    ::testing::Values(inScene("contact: {ground: .inf}", "contact.ground"),
                      inScene("contact: {ground: low}", "contact.ground"),
                      inScene("contact: {friction: -0.1}", "contact.friction: '-0.1' (allowed: 0 to 10)"),
                      inScene("contact: {friction: 11}", "contact.friction"),
                      inScene("contact: {friction: .nan}", "contact.friction"),
                      inScene("contact: {self: 1}", "contact.self"),
                      inScene("contact: {obstacles: ''}", "contact.obstacles"),
                      inScene("contact: {obstacles: 'http://a/b.urdf'}", "contact.obstacles"),
                      inScene("contact: {grund: 0}", "contact.grund: unknown key, did you mean ground?"),
                      inScene("contact: [0]", "contact")));

TEST(Scene, QuaternionsAreMadeUnitLength) {
  const Scene scene = parse(BODY + "tool: {edge: [[0, 0, 0], [0, 0, 1]], poses: [[0, 0, 0, 0, 0, 0, 0.7071, 0.7071]]}");
  EXPECT_NEAR(scene.tool->poses[0].pose.orientation.norm(), 1, 1e-15);  // rounding of one division
}

TEST(Scene, LongestAllowedLabelIsKept) {
  const std::string label(MAX_LABEL, 'x');
  EXPECT_EQ(parse(BODY + "cuts: [{normal: [1, 0, 0], label: " + label + "}]").cuts[0].plane.label, label);
}

TEST(Scene, PathsAreTakenFromItsFolder) {
  EXPECT_EQ(parse("body: {mesh: meshes/a.msh}").body.mesh, "/folder/meshes/a.msh");
  EXPECT_EQ(parse("body: {mesh: /other/a.msh}").body.mesh, "/other/a.msh");
}

TEST(SceneFile, JsonIsYamlToo) {
  const SceneFile file(R"({"body": {"grid": {"cells": [1, 1, 1]}}, "gravity": [0, 0, -1.5]})", "scene.json");
  EXPECT_EQ(loadScene(file.path()).gravity, Vec3(0, 0, -1.5));
}

TEST(SceneFile, OverridesReplaceAndAdd) {
  const SceneFile file(BODY + "cuts: [{normal: [0, 1, 0]}]\n");
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
    const std::string message = fileComplaint(BODY + "cuts: []\nsolver: {time_step: 0.1}\n", {bad});
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

TEST(Scene, GridTooLargeForAMachineIsRefusedWhenLoaded) {
  EXPECT_THROW(loadMesh(parse("body: {grid: {cells: [2000000000, 2000000000, 2000000000]}}")), InputError);
}

TEST(SceneFile, ShippedScenesLoad) {
  for (const char* name : {"demo", "bar", "movement_independence", "crossing_cuts", "animal", "slit_plane",
                           "dropped_plate", "thrown_figure"}) {
    const std::string address = std::string("package://incision/config/scenes/") + name + ".yaml";
    const Scene scene = loadScene(resolvePath(address, ""));
    EXPECT_GT(loadMesh(scene).elements.size(), 0u) << name;
  }
}

}  // namespace
}  // namespace incision
