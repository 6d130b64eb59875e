#include "incision/mesh/skin_depth.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <limits>

namespace incision {
namespace {

Vec3 nearestOnSegment(const Vec3& a, const Vec3& b, const Vec3& point) {
  const Vec3 along = b - a;
  const double length = along.squaredNorm();
  return a + (length > 0 ? std::clamp((point - a).dot(along) / length, 0.0, 1.0) : 0.0) * along;
}

}  // namespace

/// The foot in the triangle's plane where that lies inside, else the nearest point of its three edges.
Vec3 nearestOnTriangle(const std::array<Vec3, 3>& triangle, const Vec3& point) {
  const Vec3 normal = (triangle[1] - triangle[0]).cross(triangle[2] - triangle[0]);
  bool inside = normal.squaredNorm() > 0;
  Vec3 best = triangle[0];
  for (int i = 0; i < 3; ++i) {
    const Vec3 &a = triangle[i], &b = triangle[(i + 1) % 3];
    inside = inside && (b - a).cross(point - a).dot(normal) >= 0;
    const Vec3 near = nearestOnSegment(a, b, point);
    if ((near - point).squaredNorm() < (best - point).squaredNorm()) best = near;
  }
  return inside ? Vec3(point - (point - triangle[0]).dot(normal) / normal.squaredNorm() * normal) : best;
}

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
