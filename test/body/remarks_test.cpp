#include "incision/body/remarks.h"

#include <gtest/gtest.h>

#include "support/scenes.h"

namespace incision::test {
namespace {

Place beside(const std::string& said_at) {
  Place place(Vec3(5, 0, 0), Vec3(6, 1, 1));
  place.said_at = said_at;
  return place;
}

/// A bar that falls, but is held.
Scene heldBar() {
  Scene scene = softBar();
  scene.gravity = Vec3(0, 0, -9.81);
  scene.boundary = {clampLeftEnd()};
  return scene;
}

std::vector<std::string> remarksOn(const Scene& scene, TetMesh mesh) {
  return incision::remarksOn(scene, CutMesh(std::move(mesh)));
}
std::vector<std::string> remarksOn(const Scene& scene) { return remarksOn(scene, loadMesh(scene)); }

TEST(Remarks, AreNoneOnASceneThatIsMeantSo) { EXPECT_TRUE(remarksOn(heldBar()).empty()); }

TEST(Remarks, NameClampsThatHoldNothing) {
  Scene scene = heldBar();
  Clamp clamp;
  clamp.place = beside("scene.yaml: boundary.1");
  scene.boundary.push_back(clamp);
  scene.boundary.push_back(clampLeftEnd());
  const std::vector<std::string> remarks = remarksOn(scene);
  ASSERT_EQ(remarks.size(), 2u);
  EXPECT_EQ(remarks[0], "scene.yaml: boundary.1: box [[5, 0, 0], [6, 1, 1]] has no node of the mesh: it holds nothing");
  EXPECT_EQ(remarks[1],
            "box [[-1, -1, -1], [1e-06, 1, 1]] has only nodes that entries before it hold: it holds nothing");
}

TEST(Remarks, NameLoadsThatLieOnNoFace) {
  Scene scene = heldBar();
  TetMesh mesh = loadMesh(scene);
  PhysicalGroup inner;  // has a node, but no triangle
  inner.name = "inner";
  inner.dimension = 0;
  inner.nodes = {7};
  mesh.groups.push_back(inner);
  Load box, group;
  box.place = beside("scene.yaml: loads.0");
  group.place.group = "inner";
  group.place.said_at = "scene.yaml: loads.1";
  scene.loads = {box, group};
  const std::vector<std::string> remarks = remarksOn(scene, mesh);
  ASSERT_EQ(remarks.size(), 2u);
  EXPECT_EQ(remarks[0].find("scene.yaml: loads.0: box [[5, 0, 0], [6, 1, 1]] has no face"), 0u) << remarks[0];
  EXPECT_EQ(remarks[1].find("scene.yaml: loads.1: group 'inner' has no face"), 0u) << remarks[1];
}

TEST(Remarks, TellOfABodyThatNothingHolds) {
  Scene scene = heldBar();
  scene.boundary[0].place = beside("");
  ASSERT_EQ(remarksOn(scene).size(), 2u);
  EXPECT_EQ(remarksOn(scene)[1], "nothing holds the body, neither a clamp nor contact: it falls");
  scene.boundary.clear();
  ASSERT_EQ(remarksOn(scene).size(), 1u);
  Scene on_ground = scene, weightless = scene;
  on_ground.contact = ContactSettings();
  weightless.gravity.setZero();
  EXPECT_TRUE(remarksOn(on_ground).empty());
  EXPECT_TRUE(remarksOn(weightless).empty());
}

TEST(Remarks, AskWhetherALargeMeshIsInMillimetres) {
  Scene scene = heldBar();
  TetMesh mesh = loadMesh(scene);
  for (Vec3& node : mesh.nodes) node *= 80;
  scene.boundary[0].place.box.max = {1e-6, 1e3, 1e3};
  EXPECT_TRUE(remarksOn(scene, mesh).empty()) << "a grid";
  scene.body.meshes = {PlacedMesh()};
  ASSERT_EQ(remarksOn(scene, mesh).size(), 1u);
  EXPECT_NE(remarksOn(scene, mesh)[0].find("scale: 0.001"), std::string::npos) << remarksOn(scene, mesh)[0];
  scene.body.meshes[0].scale = 80;
  EXPECT_TRUE(remarksOn(scene, mesh).empty()) << "a scale that was chosen";
}

}  // namespace
}  // namespace incision::test
