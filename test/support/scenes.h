#pragma once

#include <sstream>
#include <string>

#include "incision/body/deformable_body.h"
#include "support/cuts.h"

namespace incision::test {

/// A soft bar 1 × 0.25 × 0.25 m of 8 × 2 × 2 cells, free and without gravity, solved directly on one thread.
inline Scene softBar() {
  Scene scene;
  scene.body.grid = GridSettings{{8, 2, 2}, Vec3(1, 0.25, 0.25), Vec3::Zero()};
  scene.body.material.young_modulus = 1e5;
  scene.body.material.poisson_ratio = 0.3;
  scene.gravity = Vec3::Zero();
  scene.solver.method = Method::DIRECT;
  scene.solver.threads = 1;
  return scene;
}

inline Clamp clampLeftEnd() { return {{Vec3(-1, -1, -1), Vec3(1e-6, 1, 1)}, Vec3::Zero()}; }

/// The bar 1 × 0.25 × 0.25 m whose cost is watched: held at x = 0 it swings under gravity, and 1e-4 ends the iteration.
inline Scene swingingBar(const std::array<int, 3>& cells, double young_modulus) {
  Scene scene;
  scene.body.grid = GridSettings{cells, Vec3(1, 0.25, 0.25), Vec3::Zero()};
  scene.body.material.young_modulus = young_modulus;
  scene.body.material.poisson_ratio = 0.45;
  scene.boundary = {clampLeftEnd()};
  scene.solver.method = Method::ITERATIVE;
  scene.solver.tolerance = 1e-4;
  return scene;
}

using incision::plane;
using incision::rectangle;

/// A cut through the middle of the swinging bar, which goes through few nodes.
inline PlaneCut slantedCut() { return plane(Vec3(0.51, 0.12, 0.12), Vec3(1, 0.1, 0.05)); }

/// Three cuts of the soft bar that cross each other, the last one bounded: the first at a given time [s], the others at
/// 0.05 and 0.1 s.
inline std::vector<ScheduledCut> crossingCuts(double first) {
  return {{first, plane(Vec3(0.61, 0, 0), Vec3(1, 0.3, 0.2))},
          {0.05, plane(Vec3(0.3, 0.12, 0.1), Vec3(0.1, 0.2, 1))},
          {0.1, rectangle(Vec3(0.35, 0.1, 0), Vec3(1, 0.2, 0), Vec3::UnitY(), 0.2, 0.4)}};
}

inline void run(DeformableBody* body, int steps) {
  for (int k = 0; k < steps; ++k) body->step();
}

inline double largestDifference(const std::vector<Vec3>& a, const std::vector<Vec3>& b) {
  double largest = a.size() == b.size() ? 0 : std::numeric_limits<double>::infinity();
  for (std::size_t i = 0; i < std::min(a.size(), b.size()); ++i) largest = std::max(largest, (a[i] - b[i]).norm());
  return largest;
}

inline DeformableBody makeBody(const Scene& scene) { return DeformableBody(scene, loadMesh(scene)); }

/// As it is saved.
inline std::string bytesOf(const DeformableBody& body) {
  std::ostringstream bytes;
  body.save(bytes);
  return bytes.str();
}

}  // namespace incision::test
