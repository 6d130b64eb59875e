#include "incision/scene/scene.h"

#include <gtest/gtest.h>
#include <yaml-cpp/yaml.h>

#include <string>

#include "incision/base/input_error.h"

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

TEST(Scene, EverySectionArrivesInItsSettings) {
  const Scene scene = parse(R"(
body: {grid: {cells: [16, 4, 2]}, material: {density: 1050}}
gravity: [1, 2, 3]
boundary: [{box: [[-1, -2, -3], [1, 2, 3]]}, {box: [[4, 4, 4], [5, 5, 5]]}]
loads: [{box: [[0, 0, 0], [1, 1, 1]], traction: [7, 8, 9]}]
solver: {time_step: 0.005}
cuts: [{time: 0.25, normal: [0, 0, 1]}, {time: 0.5, normal: [0, 1, 0]}]
fracture: {tensile_strength: 1e5}
contact: {obstacles: room.urdf}
tools: {lancet: {type: blade, edge: [[0, 0, 0], [0, 0, 0.1]]}, knife: {type: blade, edge: [[0, 0, 0], [0, 0, 0.1]], frame: knife}}
)");
  EXPECT_EQ(scene.body.grid->cells, (std::array<int, 3>{16, 4, 2}));
  EXPECT_EQ(scene.body.material.density, 1050);
  EXPECT_EQ(scene.gravity, Vec3(1, 2, 3));
  ASSERT_EQ(scene.boundary.size(), 2u);
  EXPECT_EQ(scene.boundary[1].place.box.max, Vec3(5, 5, 5));
  ASSERT_EQ(scene.loads.size(), 1u);
  EXPECT_EQ(scene.loads[0].traction, Vec3(7, 8, 9));
  EXPECT_EQ(scene.solver.time_step, 0.005);
  ASSERT_EQ(scene.cuts.size(), 2u);
  EXPECT_EQ(scene.cuts[1].time, 0.5);
  ASSERT_TRUE(scene.fracture);
  EXPECT_EQ(scene.fracture->tensile_strength, 1e5);
  ASSERT_TRUE(scene.contact);
  EXPECT_EQ(scene.contact->obstacles, "/folder/room.urdf");
  ASSERT_EQ(scene.tools.size(), 2u);
  EXPECT_EQ(scene.tools[0].name, "knife");
  EXPECT_EQ(scene.tools[0].frame, "knife");
  EXPECT_EQ(scene.tools[1].name, "lancet");
}

TEST(Scene, WhatIsNotGivenKeepsTheStagesDefault) {
  const Scene scene = parse(BODY + "loads:\nsolver:\ncontact:\n");
  EXPECT_EQ(scene.body.material.young_modulus, Material().young_modulus);
  EXPECT_EQ(scene.body.frame, BodySettings().frame);
  EXPECT_EQ(scene.solver.time_step, SolverSettings().time_step);
  EXPECT_EQ(scene.gravity, Scene().gravity);
  EXPECT_TRUE(scene.boundary.empty() && scene.loads.empty() && scene.cuts.empty());
  ASSERT_TRUE(scene.contact);
  EXPECT_FALSE(scene.contact->ground);
  EXPECT_TRUE(scene.contact->obstacles.empty() && scene.contact->self);
  EXPECT_EQ(scene.contact->friction, ContactSettings().friction);
  EXPECT_FALSE(scene.fracture);
  EXPECT_TRUE(scene.tools.empty());
}

TEST(Scene, BadSectionsAreRefusedWithSourceAndKey) {
  EXPECT_EQ(complaint("{}"), "scene.yaml: the key body is missing");
  EXPECT_EQ(complaint("[1, 2]"),
            "scene.yaml: a list of 2 (allowed: a map with body, gravity, boundary, loads, solver, cuts, fracture, "
            "contact, tools)");
  EXPECT_EQ(
      complaint(BODY + "tols: 1"),
      "scene.yaml: tols: unknown key, did you mean tools? (allowed: body, gravity, boundary, loads, solver, cuts, "
      "fracture, contact, tools)");
  EXPECT_EQ(complaint(BODY + "gravity: -9.81"), "scene.yaml: gravity: '-9.81' (allowed: a list of 3)");
  EXPECT_EQ(complaint(BODY + "boundary: {box: 1}"), "scene.yaml: boundary: a map (allowed: a list)");
  EXPECT_EQ(complaint(BODY + "boundary: [{velocity: [0, 0, 0]}]"),
            "scene.yaml: boundary.0: needs a group or a box (allowed: one of the two)");
  EXPECT_EQ(complaint("body: {grid: {cells: [1, 1, 1]}, material: {poisson_ratio: 0.5}}"),
            "scene.yaml: body.material.poisson_ratio: '0.5' (allowed: 0 to 0.4999)");
}

TEST(Scene, GridTooLargeForAMachineIsRefusedWhenLoaded) {
  EXPECT_THROW(loadMesh(parse("body: {grid: {cells: [2000000000, 2000000000, 2000000000]}}")), InputError);
}

}  // namespace
}  // namespace incision
