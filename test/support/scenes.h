#pragma once

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

inline Hold holdLeftEnd() { return {{Vec3(-1, -1, -1), Vec3(1e-6, 1, 1)}, Vec3::Zero()}; }

using incision::plane;
using incision::rectangle;

inline void run(DeformableBody* body, int steps) {
  for (int k = 0; k < steps; ++k) body->step();
}

inline double largestDifference(const std::vector<Vec3>& a, const std::vector<Vec3>& b) {
  double largest = a.size() == b.size() ? 0 : std::numeric_limits<double>::infinity();
  for (std::size_t i = 0; i < std::min(a.size(), b.size()); ++i) largest = std::max(largest, (a[i] - b[i]).norm());
  return largest;
}

}  // namespace incision::test
