#pragma once

#include <vector>

#include "incision/scene/scene.h"

namespace incision::bench {

/// A quarter of the mass [kg] of each element at each of its nodes.
inline std::vector<double> lumpedMasses(const Scene& scene, const TetMesh& mesh) {
  std::vector<double> masses(mesh.nodes.size(), 0);
  for (std::size_t e = 0; e < mesh.elements.size(); ++e)
    for (int node : mesh.elements[e])
      masses[node] += scene.body.material.density * elementVolume(mesh, static_cast<int>(e)) / 4;
  return masses;
}

}  // namespace incision::bench
