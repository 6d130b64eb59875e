#pragma once

#include <Eigen/Geometry>
#include <algorithm>
#include <functional>
#include <vector>

#include "incision/body/deformable_body.h"

namespace incision::test {

/// What a breaking body did.
struct Breaking {
  std::vector<CrackResult> events;
  double largest_pull = 0;  ///< [N]

  std::vector<CrackResult> of(CrackChange change) const {
    std::vector<CrackResult> found;
    for (const CrackResult& event : events)
      if (event.change == change) found.push_back(event);
    return found;
  }
};

/// A hold for every node of the mesh that is chosen, at its place in `placed`, so that a turned body can be held too.
/// Choice and velocity go by the place in `mesh`.
inline std::vector<Clamp> clampEach(const TetMesh& mesh, const std::function<bool(const Vec3&)>& chosen,
                                    const TetMesh& placed, const std::function<Vec3(const Vec3&)>& velocity) {
  std::vector<Clamp> clamps;
  const Vec3 room = Vec3::Constant(1e-9);
  for (std::size_t n = 0; n < mesh.nodes.size(); ++n)
    if (chosen(mesh.nodes[n]))
      clamps.push_back({{placed.nodes[n] - room, placed.nodes[n] + room}, velocity(mesh.nodes[n])});
  return clamps;
}

inline TetMesh turned(TetMesh mesh, const Mat3& R) {
  for (Vec3& X : mesh.nodes) X = R * X;
  return mesh;
}

inline Vec3 atRest(const Vec3&) { return Vec3::Zero(); }

/// A material without inertia or spring: each step ends in equilibrium.
inline Scene quasiStatic(double young_modulus, double poisson_ratio, double time_step) {
  Scene scene;
  scene.gravity = Vec3::Zero();
  scene.body.material = {young_modulus, poisson_ratio, 1e-3, 0, 0};
  scene.solver = {time_step, Method::DIRECT, 1e-6, 1};
  return scene;
}

/// Force [N] along a unit direction through a body of that length [m] in equilibrium: ∫ d·σ d dV / length, by virtual
/// work.
inline double pullOf(const DeformableBody& body, const Vec3& d, double length) {
  const std::vector<Mat3> stress = body.partStress();
  double sum = 0;
  for (std::size_t p = 0; p < stress.size(); ++p) {
    const Part& part = body.mesh().parts()[p];
    sum += part.fraction * elementVolume(body.mesh().mesh(), part.element) * d.dot(stress[p] * d);
  }
  return sum / length;
}

/// A material of this tensile strength [Pa] that bears any compression.
inline FractureSettings tensile(double strength) {
  FractureSettings settings;
  settings.tensile_strength = strength;
  return settings;
}

/// Takes steps and collects what happens, until there are so many pieces or so many steps are taken.
inline Breaking breakInto(DeformableBody* body, int pieces, int steps, const std::function<double()>& pull = {}) {
  Breaking run;
  for (int k = 0; k < steps && body->counts().pieces < pieces; ++k) {
    for (const CrackResult& event : body->step().cracks) run.events.push_back(event);
    if (pull) run.largest_pull = std::max(run.largest_pull, pull());
  }
  return run;
}

}  // namespace incision::test
