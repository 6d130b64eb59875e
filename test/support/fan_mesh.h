#pragma once

#include <cmath>

#include "incision/mesh/tet_mesh.h"

namespace incision {

/// As many elements as `rim` round one edge.
inline TetMesh fanMesh(int rim) {
  TetMesh fan;
  fan.nodes = {Vec3(0, 0, -1), Vec3(0, 0, 1)};
  for (int i = 0; i < rim; ++i) {
    const double angle = 2 * M_PI * i / rim;
    fan.nodes.emplace_back(std::cos(angle), std::sin(angle), 0);
    fan.elements.push_back({0, 1, 2 + i, 2 + (i + 1) % rim});
  }
  for (auto& e : fan.elements)
    if (sixVolumes(fan.nodes[e[0]], fan.nodes[e[1]], fan.nodes[e[2]], fan.nodes[e[3]]) < 0) std::swap(e[2], e[3]);
  return fan;
}

}  // namespace incision
