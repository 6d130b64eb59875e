#include <gtest/gtest.h>

#include <cmath>

#include "support/contacts.h"
#include "support/mesh_folder.h"
#include "support/solid_meshes.h"

namespace incision::test {
namespace {

const double HALF_WIDTH = 4;  // of the block, and its height; contacts are up to 0.14 m wide

// A block under z = 0, its cells finest where the sphere touches: 0.02 m at `cells` = 12.
TetMesh gradedBlock(int cells) {
  TetMesh mesh = gridMesh({{2 * cells, 2 * cells, cells}, Vec3(2, 2, 1), Vec3(-1, -1, -1)});
  const double grading = 5.2;
  for (Vec3& X : mesh.nodes) X = HALF_WIDTH * (grading * X).array().sinh() / std::sinh(grading);
  return mesh;
}

// What the base carries: as virtual work says, the mean of σ_zz over the lowest layer of cells, times its area.
double reaction(const DeformableBody& body, int cells) {
  const CutMesh& mesh = body.mesh();
  const std::vector<Mat3> stress = body.partStress();
  double height = std::numeric_limits<double>::infinity(), sum = 0;
  for (const Vec3& X : mesh.mesh().nodes)
    if (X.z() > -HALF_WIDTH + 1e-9) height = std::min(height, X.z() + HALF_WIDTH);
  for (std::size_t p = 0; p < stress.size(); ++p) {
    const auto& element = mesh.mesh().elements[mesh.parts()[p].element];
    const bool lowest = std::all_of(element.begin(), element.end(),
                                    [&](int n) { return mesh.mesh().nodes[n].z() < -HALF_WIDTH + height + 1e-9; });
    if (lowest) sum -= stress[p](2, 2) * elementVolume(mesh.mesh(), mesh.parts()[p].element);
  }
  EXPECT_GT(cells, 0);
  return sum / height;
}

// Force [N] of a sphere of radius 1 m, such a shape, pressed in by each depth [m], statically.
std::vector<double> forces(int cells, const std::vector<double>& depths, const Material& material,
                           const std::string& shape = "<sphere radius='1'/>") {
  Scene scene;
  scene.body.material = material;
  scene.body.warping = false;
  scene.gravity.setZero();
  scene.boundary = {{{Vec3(-9, -9, -9), Vec3(9, 9, -HALF_WIDTH + 1e-9)}, Vec3::Zero()}};
  scene.solver = {1, Method::ITERATIVE, 1e-6, 2};
  scene.contact = ContactSettings();
  scene.contact->friction = 0;
  scene.contact->obstacles = "ball.urdf";
  DeformableBody body(scene, gradedBlock(cells), {{}, urdfOf(shape, "0 0 1")});
  std::vector<double> found;
  double depth = 0;
  for (const double next : depths) {
    for (; depth < next - 1e-12; depth += 0.001) {
      body.moveObstacle(0, {Vec3(0, 0, -depth - 0.001), Eigen::Quaterniond::Identity()});
      body.step();
    }
    for (int k = 0; k < 3; ++k) body.step();
    found.push_back(reaction(body, cells));
  }
  return found;
}

// F = 4/3 E/(1 − ν²) √R d^(3/2), Hertz 1882.
TEST(Contact, GivesHertzForce) {
  const Material material = {1e6, 0.3, 1e-9, 0, 0};
  const std::vector<double> depths = {0.005, 0.01, 0.02};
  for (const int cells : {6, 12, 24}) {
    const std::vector<double> found = forces(cells, depths, material);
    for (std::size_t i = 0; i < depths.size(); ++i) {
      const double exact = 4.0 / 3 * material.young_modulus / (1 - 0.3 * 0.3) * std::pow(depths[i], 1.5);
      std::printf("%d cells, depth %.3f m: %.1f N, %+.1f %%\n", 24 * cells * cells * cells, depths[i], found[i],
                  100 * (found[i] / exact - 1));
      if (cells == 24) {
        EXPECT_NEAR(found[i], exact, 0.1 * exact) << depths[i];
      }
    }
  }
}

// The sphere's triangles are a sixth as wide as the contact where it is narrowest.
TEST(Contact, GivesHertzForceUnderASphereOfTriangles) {
  const MeshFolder meshes("hertz");
  const std::string ball = meshes.shape("ball.stl", asBinaryStl(sphereMesh(1, 150)));
  const std::vector<double> depths = {0.005, 0.01, 0.02};
  const std::vector<double> found = forces(24, depths, {1e6, 0.3, 1e-9, 0, 0}, ball);
  for (std::size_t i = 0; i < depths.size(); ++i) {
    const double exact = 4.0 / 3 * 1e6 / (1 - 0.3 * 0.3) * std::pow(depths[i], 1.5);
    std::printf("depth %.3f m: %.1f N, %+.1f %%\n", depths[i], found[i], 100 * (found[i] / exact - 1));
    EXPECT_NEAR(found[i], exact, 0.1 * exact) << depths[i];
  }
}

}  // namespace
}  // namespace incision::test
