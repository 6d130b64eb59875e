#include "incision/fem/boundary.h"

#include <Eigen/Geometry>
#include <algorithm>

namespace incision {
namespace {

template <typename Test>
bool allNodes(const std::array<int, 4>& element, const std::array<int, 3>& face, const Test& test) {
  return std::all_of(face.begin(), face.end(), [&](int I) { return test(element[I]); });
}

/// Corners of what a part owns of an element's face, as weights of the face's nodes; empty when it owns nothing.
FacePolygon ownedFace(const CutMesh& mesh, int part, int face) {
  FacePolygon polygon;
  const Polytope& polytope = mesh.polytope(part);
  const Facet* facet = polytope.onFace(face);
  if (!facet) return polygon;
  for (int c : facet->corners) {
    const Barycentric& b = polytope.corners[c];
    polygon.emplace_back(b[FACE_NODES[face][0]], b[FACE_NODES[face][1]], b[FACE_NODES[face][2]]);
  }
  return polygon;
}

/// Whether a part owns area of a boundary face, or volume of an element, all of whose nodes move as one clamp:
/// between clamps that move differently the material is not held.
bool ownsClampedMaterial(const CutMesh& mesh, const std::vector<Clamp>& clamps, const std::vector<int>& held_nodes,
                         int clamp, int part) {
  const int e = mesh.parts()[part].element;
  const auto& element = mesh.mesh().elements[e];
  const auto clamped = [&](int node) {
    return held_nodes[node] >= 0 && clamps[held_nodes[node]].velocity == clamps[clamp].velocity;
  };
  if (std::all_of(element.begin(), element.end(), clamped)) return true;
  for (int f = 0; f < 4; ++f)
    if (mesh.topology().neighbours[e][f] < 0 && allNodes(element, FACE_NODES[f], clamped) &&
        faceShare(ownedFace(mesh, part, f)) > MIN_OVERLAP)
      return true;
  return false;
}

}  // namespace

std::vector<int> heldNodes(const TetMesh& mesh, const std::vector<Clamp>& clamps) {
  std::vector<int> held(mesh.nodes.size(), -1);
  for (std::size_t h = 0; h < clamps.size(); ++h)
    for (int n : nodesAt(clamps[h].place, mesh))
      if (held[n] < 0) held[n] = static_cast<int>(h);
  return held;
}

std::vector<int> heldCopies(const CutMesh& mesh, const std::vector<Clamp>& clamps, const std::vector<int>& held_nodes) {
  std::vector<int> held(mesh.numCopies(), -1);
  for (std::size_t n = 0; n < held_nodes.size(); ++n)
    if (held_nodes[n] >= 0 && mesh.ownCopy(static_cast<int>(n)) >= 0)
      held[mesh.ownCopy(static_cast<int>(n))] = held_nodes[n];
  for (std::size_t p = 0; p < mesh.parts().size(); ++p)
    for (int c : mesh.parts()[p].copies) {
      const int clamp = held_nodes[mesh.copyNode(c)];
      if (clamp >= 0 && held[c] < 0 && ownsClampedMaterial(mesh, clamps, held_nodes, clamp, static_cast<int>(p)))
        held[c] = clamp;
    }
  return held;
}

std::vector<std::vector<Vec3>> loadForces(const CutMesh& mesh, const std::vector<Load>& loads) {
  std::vector<std::vector<Vec3>> forces(loads.size(), std::vector<Vec3>(mesh.numCopies(), Vec3::Zero()));
  const TetMesh& rest = mesh.mesh();
  for (std::size_t l = 0; l < loads.size(); ++l)
    for (const auto& [e, f] : boundaryFacesAt(loads[l].place, rest, mesh.topology())) {
      const auto& nodes = FACE_NODES[f];
      const Vec3 &A = rest.nodes[rest.elements[e][nodes[0]]], &B = rest.nodes[rest.elements[e][nodes[1]]],
                 &C = rest.nodes[rest.elements[e][nodes[2]]];
      const double area = 0.5 * (B - A).cross(C - A).norm();
      for (int p = e; p >= 0; p = mesh.parts()[p].next) {
        const FacePolygon owned = ownedFace(mesh, p, f);
        if (owned.empty()) continue;
        const FacePoint N = centroid(owned);
        for (int i = 0; i < 3; ++i)
          forces[l][mesh.parts()[p].copies[nodes[i]]] += N[i] * area * faceShare(owned) * loads[l].traction;
      }
    }
  return forces;
}

}  // namespace incision
