#include "incision/mesh/placed_mesh.h"

#include <gtest/gtest.h>

#include <Eigen/Geometry>

#include "incision/mesh/grid_mesh.h"
#include "incision/mesh/place.h"
#include "support/section.h"
#include "support/test_file.h"

namespace incision {
namespace {

const std::string ONE_ELEMENT = R"($MeshFormat
2.2 0 8
$EndMeshFormat
$PhysicalNames
1
2 1 "skin"
$EndPhysicalNames
$Nodes
4
1 0 0 0
2 1000 0 0
3 0 2000 0
4 0 0 3000
$EndNodes
$Elements
2
1 2 2 1 1 1 2 3
2 4 2 5 1 1 2 3 4
$EndElements
)";

std::vector<PlacedMesh> parse(const YamlValue& value) {
  return parsePlacedMeshes(value.map({"mesh", "scale", "meshes", "grid"}));
}

std::vector<PlacedMesh> parse(const std::string& text) { return parse(test::section("body", text)); }

std::vector<std::string> names(const TetMesh& mesh) {
  std::vector<std::string> all;
  for (const PhysicalGroup& group : mesh.groups)
    all.push_back(std::to_string(group.dimension) + " " + std::to_string(group.tag) + " " + group.name);
  return all;
}

TEST(PlacedMesh, OneFileIsAMeshWithItsUnit) {
  EXPECT_TRUE(parse("{grid: {cells: [1, 1, 1]}}").empty());
  const auto metres = parse("{mesh: a.msh}"), millimetres = parse("{mesh: a.msh, scale: 0.001}");
  ASSERT_EQ(metres.size(), 1u);
  EXPECT_EQ(metres[0].file, "/folder/a.msh");
  EXPECT_EQ(metres[0].name, "");
  EXPECT_EQ(metres[0].scale, 1);
  EXPECT_EQ(millimetres[0].scale, 0.001);
}

TEST(PlacedMesh, SeveralComeInTheOrderOfTheirNames) {
  const auto meshes =
      parse("{meshes: {liver: {file: l.msh, scale: 0.001, pose: [1, 2, 3, 0, 0, 0]}, gall-2: {file: /g.msh}}}");
  ASSERT_EQ(meshes.size(), 2u);
  EXPECT_EQ(meshes[0].name, "gall-2");
  EXPECT_EQ(meshes[0].file, "/g.msh");
  EXPECT_EQ(meshes[1].name, "liver");
  EXPECT_EQ(meshes[1].file, "/folder/l.msh");
  EXPECT_EQ(meshes[1].scale, 0.001);
  EXPECT_EQ(meshes[1].position, Vec3(1, 2, 3));
  EXPECT_EQ(meshes[1].rotation, Mat3::Identity());
}

TEST(PlacedMesh, RollPitchAndYawTurnAboutFixedAxesInThisOrder) {
  const auto turned = [](const std::string& angles) {
    return parse("{meshes: {a: {file: a.msh, pose: [0, 0, 0, " + angles + "]}}}")[0].rotation;
  };
  EXPECT_LT((turned("1.5707963267948966, 0, 0") * Vec3::UnitY() - Vec3::UnitZ()).norm(), 1e-15);
  EXPECT_LT((turned("0, 1.5707963267948966, 0") * Vec3::UnitZ() - Vec3::UnitX()).norm(), 1e-15);
  EXPECT_LT((turned("0, 0, 1.5707963267948966") * Vec3::UnitX() - Vec3::UnitY()).norm(), 1e-15);
  // First about x: y to z; then about the fixed z, which leaves it.
  EXPECT_LT((turned("1.5707963267948966, 0, 1.5707963267948966") * Vec3::UnitY() - Vec3::UnitZ()).norm(), 1e-15);
}

TEST(PlacedMesh, BadValuesAreRefused) {
  const std::string many(MAX_NAME + 1, 'x');
  std::string too_many = "{meshes: {";
  for (std::size_t i = 0; i <= MAX_MESHES; ++i) too_many += "m" + std::to_string(i) + ": {file: a.msh}, ";
  test::expectRefused(
      [](const YamlValue& value) { return parse(value); }, "body",
      {{"{mesh: a.msh, scale: 0}", ".scale: '0' (allowed: 1e-09 to 1e+09)"},
       {"{mesh: a.msh, scale: .inf}", ".scale: '.inf'"},
       {"{grid: {cells: [1, 1, 1]}, scale: 1}", ".scale: is the unit of a mesh"},
       {"{meshes: {a: {file: a.msh}}, scale: 1}", ".scale: is the unit of a mesh"},
       {"{meshes: {}}", ".meshes: a map (allowed: a map of 1 to 1000 names)"},
       {"{meshes: [a.msh]}", ".meshes: a list of 1"},
       {"{meshes: {'a/b': {file: a.msh}}}", ".meshes: the name 'a/b' (allowed: 1 to 255 letters"},
       {"{meshes: {'': {file: a.msh}}}", ".meshes: the name ''"},
       {"{meshes: {" + many + ": {file: a.msh}}}", ".meshes: the name 'xxx"},
       {"{meshes: {a: {file: a.msh}, a: {file: b.msh}}}", ".meshes.a: given twice"},
       {"{meshes: {a: {scale: 1}}}", ".meshes.a: the key file is missing"},
       {"{meshes: {a: {file: a.msh, scle: 1}}}", ".meshes.a.scle: unknown key, did you mean scale?"},
       {"{meshes: {a: {file: a.msh, scale: -1}}}", ".meshes.a.scale: '-1'"},
       {"{meshes: {a: {file: a.msh, pose: [0, 0, 0]}}}", ".meshes.a.pose: a list of 3 (allowed: a list of 6)"},
       {"{meshes: {a: {file: a.msh, pose: [2e9, 0, 0, 0, 0, 0]}}}", ".meshes.a.pose.0: '2e9'"},
       {"{meshes: {a: {file: a.msh, pose: [0, 0, 0, .nan, 0, 0]}}}", ".meshes.a.pose.3: '.nan'"},
       {too_many + "}}", ".meshes: a map"}});
}

TEST(PlacedMesh, IsScaledThenTurnedThenMoved) {
  const test::TestFile file("placed.msh", ONE_ELEMENT);
  const auto meshes = parse("{meshes: {a: {file: " + file.path() + ", scale: 0.001, pose: [5, 0, 0, 0, 0, " +
                            std::to_string(M_PI / 2) + "]}}}");
  const TetMesh mesh = readPlacedMeshes(meshes);
  ASSERT_EQ(mesh.nodes.size(), 4u);
  EXPECT_LT((mesh.nodes[0] - Vec3(5, 0, 0)).norm(), 1e-6);
  EXPECT_LT((mesh.nodes[1] - Vec3(5, 1, 0)).norm(), 1e-6);
  EXPECT_LT((mesh.nodes[2] - Vec3(3, 0, 0)).norm(), 1e-5);
  EXPECT_LT((mesh.nodes[3] - Vec3(5, 0, 3)).norm(), 1e-6);
  EXPECT_NEAR(elementVolume(mesh, 0), 1, 1e-14);
}

TEST(PlacedMesh, GroupsOfSeveralAreCalledAfterTheirMesh) {
  const test::TestFile file("placed.msh", ONE_ELEMENT);
  const TetMesh alone = readPlacedMeshes(parse("{mesh: " + file.path() + "}"));
  EXPECT_EQ(names(alone), (std::vector<std::string>{"2 1 skin", "3 5 5"}));
  const TetMesh both = readPlacedMeshes(parse("{meshes: {right: {file: " + file.path() +
                                              ", pose: [9000, 0, 0, 0, 0, 0]}, left: {file: " + file.path() + "}}}"));
  EXPECT_EQ(names(both), (std::vector<std::string>{"2 1 left/skin", "2 2 right/skin", "3 1 left/5", "3 2 left",
                                                   "3 3 right/5", "3 4 right"}));
  ASSERT_EQ(both.elements, (std::vector<std::array<int, 4>>{{0, 1, 2, 3}, {4, 5, 6, 7}}));
  Place place;
  place.group = "right";
  EXPECT_EQ(elementsAt(place, both), std::vector<int>{1});
  EXPECT_EQ(nodesAt(place, both), (std::vector<int>{4, 5, 6, 7}));
  place.group = "right/skin";
  EXPECT_EQ(nodesAt(place, both), (std::vector<int>{4, 5, 6}));
  const auto faces = boundaryFacesAt(place, both, buildTopology(both));
  ASSERT_EQ(faces.size(), 1u);
  EXPECT_EQ(faces[0].element, 1);
}

TEST(PlacedMesh, JoiningKeepsEachMeshAsItWas) {
  const TetMesh a = gridMesh({{2, 1, 1}, Vec3::Ones(), Vec3::Zero()});
  const TetMesh b = gridMesh({{1, 3, 1}, Vec3::Ones(), Vec3(5, 0, 0)});
  const TetMesh both = joined({a, b});
  EXPECT_EQ(both.nodes.size(), a.nodes.size() + b.nodes.size());
  ASSERT_EQ(both.elements.size(), a.elements.size() + b.elements.size());
  for (std::size_t e = 0; e < b.elements.size(); ++e)
    for (int i = 0; i < 4; ++i)
      EXPECT_EQ(both.nodes[both.elements[a.elements.size() + e][i]], b.nodes[b.elements[e][i]]);
  const MeshTopology topology = buildTopology(both), first = buildTopology(a);
  for (std::size_t e = 0; e < a.elements.size(); ++e) EXPECT_EQ(topology.neighbours[e], first.neighbours[e]);
}

TEST(PlacedMesh, WhatComesToLieTooFarOffOrGetsTooSmallIsRefused) {
  const test::TestFile file("placed.msh", ONE_ELEMENT);
  const auto complaint = [&](const std::string& rest) -> std::string {
    try {
      readPlacedMeshes(parse("{meshes: {a: {file: " + file.path() + ", " + rest + "}}}"));
      return "";
    } catch (const InputError& error) {
      return error.what();
    }
  };
  EXPECT_EQ(complaint("scale: 1e5"), "");
  EXPECT_EQ(complaint("scale: 1e6").find("scene.yaml: body.meshes.a: scale and pose put a node beyond 1e9 m"), 0u);
  EXPECT_EQ(complaint("pose: [1e9, 0, 0, 0, 0, 0]").find("scene.yaml: body.meshes.a: scale and pose put"), 0u);
  // There doubles are 1e-7 m apart.
  TetMesh small = gridMesh({{1, 1, 1}, Vec3::Constant(1e-8), Vec3::Zero()});
  PlacedMesh far;
  far.position = Vec3::Constant(9e8);
  EXPECT_THROW(placed(small, far), InputError);
  far.scale = 1e6;
  EXPECT_NO_THROW(placed(small, far));
}

TEST(PlacedMesh, WhatWasMendedIsToldWithTheFilesName) {
  std::string turned = ONE_ELEMENT;
  turned.replace(turned.find("1 2 3 4\n"), 7, "2 1 3 4");
  const test::TestFile file("placed.msh", turned);
  std::vector<std::string> notes;
  readPlacedMeshes(parse("{mesh: " + file.path() + "}"), &notes);
  ASSERT_EQ(notes.size(), 1u);
  EXPECT_EQ(notes[0].find(file.path() + ": elements of negative volume, of which two nodes were swapped: 1"), 0u)
      << notes[0];
}

}  // namespace
}  // namespace incision
