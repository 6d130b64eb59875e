#include "incision/mesh/skin_depth.h"

#include <algorithm>
#include <limits>

#include "incision/base/nearest.h"

namespace incision {

SkinDepth::SkinDepth(const TetMesh& mesh, const MeshTopology& topology) : mesh_(&mesh) {
  for (std::size_t e = 0; e < mesh.elements.size(); ++e)
    for (int f = 0; f < 4; ++f) {
      if (topology.neighbours[e][f] >= 0) continue;
      faces_.emplace_back();
      for (int i = 0; i < 3; ++i) {
        const int node = mesh.elements[e][FACE_NODES[f][i]];
        faces_.back()[i] = mesh.nodes[node];
        known_[node] = 0;
      }
    }
}

double SkinDepth::at(int node) {
  const auto [known, first] = known_.try_emplace(node, 0);
  if (first) {
    double least = std::numeric_limits<double>::infinity();
    for (const std::array<Vec3, 3>& face : faces_)
      least = std::min(least, (nearestOnTriangle(face, mesh_->nodes[node]) - mesh_->nodes[node]).squaredNorm());
    known->second = std::sqrt(least);
  }
  return known->second;
}

}  // namespace incision
