#pragma once

#include <limits>
#include <vector>

#include "incision/fem/loads.h"

namespace incision {

/// Nodal forces of a load [N] at full size on a body at rest.
inline std::vector<Vec3> loadForces(const CutMesh& mesh, const Load& load) {
  std::vector<Vec3> X, forces(mesh.numCopies(), Vec3::Zero());
  for (int c = 0; c < mesh.numCopies(); ++c) X.push_back(mesh.mesh().nodes[mesh.copyNode(c)]);
  Loads loads(mesh, {load});
  loads.topologyChanged();
  loads.addTo(std::numeric_limits<double>::infinity(), X, &forces);
  return forces;
}

}  // namespace incision
