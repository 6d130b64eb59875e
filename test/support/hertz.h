#pragma once

#include <algorithm>
#include <cmath>
#include <limits>
#include <string>
#include <vector>

#include "support/contacts.h"

namespace incision::test {

/// Half the width of the block that a sphere of radius 1 m is pressed into, and its height [m]; contacts are up to
/// 0.14 m wide.
inline constexpr double HERTZ_BLOCK = 4;

/// The block under z = 0, its cells finest where the sphere touches: 0.02 m at `cells` = 12. It has 2 × 2 × 1 times as
/// many.
inline TetMesh gradedBlock(int cells) {
  TetMesh mesh = gridMesh({{2 * cells, 2 * cells, cells}, Vec3(2, 2, 1), Vec3(-1, -1, -1)});
  const double grading = 5.2;
  for (Vec3& X : mesh.nodes) X = HERTZ_BLOCK * (grading * X).array().sinh() / std::sinh(grading);
  return mesh;
}

/// What the block's base carries [N]: as virtual work says, the mean of σ_zz over the lowest layer of cells, times its
/// area.
inline double reactionOf(const DeformableBody& body) {
  const TetMesh& mesh = body.mesh().mesh();
  const std::vector<Mat3> stress = body.partStress();
  double height = std::numeric_limits<double>::infinity(), sum = 0;
  for (const Vec3& X : mesh.nodes)
    if (X.z() > -HERTZ_BLOCK + 1e-9) height = std::min(height, X.z() + HERTZ_BLOCK);
  for (std::size_t p = 0; p < stress.size(); ++p) {
    const int element = body.mesh().parts()[p].element;
    const auto& nodes = mesh.elements[element];
    const bool lowest = std::all_of(nodes.begin(), nodes.end(),
                                    [&](int n) { return mesh.nodes[n].z() < -HERTZ_BLOCK + height + 1e-9; });
    if (lowest) sum -= stress[p](2, 2) * elementVolume(mesh, element);
  }
  return sum / height;
}

/// The forces [N] of a sphere of radius 1 m, such a shape, that is pressed into the block by each depth [m], one after
/// the other, statically and without friction.
inline std::vector<double> hertzForces(int cells, const std::vector<double>& depths, const Material& material,
                                       const std::string& shape = "<sphere radius='1'/>") {
  Scene scene;
  scene.body.material = material;
  scene.body.warping = false;
  scene.gravity.setZero();
  scene.boundary = {{{Vec3(-9, -9, -9), Vec3(9, 9, -HERTZ_BLOCK + 1e-9)}, Vec3::Zero()}};
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
    found.push_back(reactionOf(body));
  }
  return found;
}

/// F = 4/3 E/(1 − ν²) √R d^(3/2) for R = 1 m (Hertz 1882) [N].
inline double hertzForce(const Material& material, double depth) {
  const double nu = material.poisson_ratio;
  return 4.0 / 3 * material.young_modulus / (1 - nu * nu) * std::pow(depth, 1.5);
}

}  // namespace incision::test
