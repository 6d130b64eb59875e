// Bodies of several mesh files.
#include <gtest/gtest.h>
#include <yaml-cpp/yaml.h>

#include <algorithm>
#include <limits>

#include "incision/body/quantities.h"
#include "incision/mesh/grid_mesh.h"
#include "incision/mesh/place.h"
#include "support/mesh_file.h"
#include "support/test_file.h"

namespace incision::test {
namespace {

/// A block of 4 × 4 × 4 cells of 5 cm with its bottom as a group, in millimetres where the scale says so.
TetMesh blockWithBase(double unit) {
  TetMesh mesh = gridMesh({{4, 4, 4}, Vec3::Constant(0.2 / unit), Vec3::Zero()});
  const MeshTopology topology = buildTopology(mesh);
  PhysicalGroup base;
  base.name = "base";
  base.tag = 1;
  base.dimension = 2;
  const Place bottom(Vec3::Constant(-1 / unit), Vec3(1 / unit, 1 / unit, 0));
  for (const auto& [e, f] : boundaryFacesAt(bottom, mesh, topology)) {
    const auto& nodes = mesh.elements[e];
    base.triangles.push_back({nodes[FACE_NODES[f][0]], nodes[FACE_NODES[f][1]], nodes[FACE_NODES[f][2]]});
  }
  mesh.groups.push_back(base);
  return mesh;
}

/// One block on the ground, held by its base, and above it another that has been turned upside down.
struct Blocks : ::testing::Test {
  TestFile lower{"lower.msh", asGmsh(blockWithBase(1))}, upper{"upper.msh", asGmsh(blockWithBase(0.001))};

  Scene scene(const std::string& contact) const {
    return parseScene(
        YAML::Load("body: {meshes: {upper: {file: " + upper.path() +
                   ", scale: 0.001, pose: [0.01, 0.21, 0.45, 3.14159265358979, 0, 0]}, lower: {file: " + lower.path() +
                   "}}, material: {young_modulus: 1e5, poisson_ratio: 0.3, stiffness_damping: 0.01}}\n"
                   "boundary: [{group: lower/base}]\n"
                   "solver: {time_step: 0.005, threads: 1}\n"
                   "contact: " +
                   contact),
        "scene.yaml", "/");
  }
};

/// The range of z of a mesh's nodes at present.
std::pair<double, double> heights(const DeformableBody& body, const std::string& group) {
  Place place;
  place.group = group;
  std::pair<double, double> range = {std::numeric_limits<double>::infinity(), -std::numeric_limits<double>::infinity()};
  const std::vector<Vec3> x = body.nodePositions();
  for (int n : nodesAt(place, body.mesh().mesh()))
    range = {std::min(range.first, x[n].z()), std::max(range.second, x[n].z())};
  return range;
}

TEST_F(Blocks, StandWhereTheSceneSaysAndAreHeldByTheirGroups) {
  const Scene both = scene("{self: true}");
  std::vector<std::string> notes;
  DeformableBody body(both, loadMesh(both, &notes));
  EXPECT_TRUE(notes.empty()) << notes[0];
  EXPECT_EQ(body.counts().pieces, 2);
  EXPECT_EQ(body.counts().elements, 2 * 6 * 64);
  EXPECT_EQ(body.counts().held_nodes, 25);
  EXPECT_NEAR(body.motion().mass, 2 * 8, 1e-9);
  EXPECT_LT((body.bounds().min - Vec3(0, 0, 0)).norm(), 1e-12);
  EXPECT_LT((body.bounds().max - Vec3(0.21, 0.21, 0.45)).norm(), 1e-12);
  EXPECT_NEAR(heights(body, "upper").first, 0.25, 1e-12);
  EXPECT_NEAR(heights(body, "upper/base").first, 0.45, 1e-12);  // it stands on its head
  EXPECT_EQ(heights(body, "lower/base"), std::make_pair(0.0, 0.0));
  EXPECT_NE(describe(body).find("from (0, 0, 0) to (0.21, 0.21, 0.45) m, of 16 kg, 25 of its 250 nodes held"),
            std::string::npos)
      << describe(body);
}

TEST_F(Blocks, TheOneThatFallsOnTheOtherComesToRestOnIt) {
  const Scene both = scene("{self: true}");
  DeformableBody body(both, loadMesh(both));
  EXPECT_EQ(body.step().contact.count, 0);
  for (int k = 0; k < 400; ++k) body.step();
  const ContactReport rest = body.step().contact;
  EXPECT_GE(rest.count, 25);
  EXPECT_LT(rest.deepest, 0.01 * 0.05);  // an element is 5 cm
  // The weight of 8 kg presses the lower block, and itself the upper, by some 2 % of 0.2 m.
  EXPECT_NEAR(heights(body, "upper").second, 0.4, 0.01);
  EXPECT_LT(body.motion().kinetic_energy, 1e-6);
  EXPECT_EQ(body.counts().pieces, 2);
}

TEST_F(Blocks, WithoutContactOneFallsThroughTheOther) {
  const Scene both = scene("{self: false}");
  DeformableBody body(both, loadMesh(both));
  for (int k = 0; k < 60; ++k) body.step();
  EXPECT_LT(heights(body, "upper").first, heights(body, "lower").first);
}

}  // namespace
}  // namespace incision::test
