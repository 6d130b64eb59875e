#pragma once

#include <cmath>
#include <vector>

#include "incision/mesh/tet_mesh.h"

namespace incision::report {

/// ‖u_h − u‖ / ‖u‖ in L², by four points an element: u_h has these values at the nodes [m], u is exact(X).
template <typename Field>
double distanceFrom(const Field& exact, const TetMesh& mesh, const std::vector<Vec3>& u) {
  constexpr double NEAR = 0.58541019662496845, AWAY = 0.13819660112501052;
  double error = 0, size = 0;
  for (std::size_t e = 0; e < mesh.elements.size(); ++e) {
    const double volume = elementVolume(mesh, static_cast<int>(e));
    for (int point = 0; point < 4; ++point) {
      Vec3 X = Vec3::Zero(), u_h = Vec3::Zero();
      for (int I = 0; I < 4; ++I) {
        X += (I == point ? NEAR : AWAY) * mesh.nodes[mesh.elements[e][I]];
        u_h += (I == point ? NEAR : AWAY) * u[mesh.elements[e][I]];
      }
      const Vec3 there = exact(X);
      error += volume * (u_h - there).squaredNorm();
      size += volume * there.squaredNorm();
    }
  }
  return std::sqrt(error / size);
}

}  // namespace incision::report
