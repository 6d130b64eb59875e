#include "incision/fem/loads.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <utility>

#include "incision/fem/owned_face.h"

namespace incision {
namespace {

/// Calls f(part, shares) for each part that owns some of the face; shares are ∫ N_I dA / A over it.
template <class Function>
void forEachOwner(const CutMesh& mesh, const ElementFace& at, const Function& f) {
  for (int p = at.element; p >= 0; p = mesh.parts()[p].next) {
    const FacePolygon owned = ownedFace(mesh, p, at.face);
    if (!owned.empty()) f(mesh.parts()[p], Vec3(centroid(owned) * faceShare(owned)));
  }
}

double areaAtRest(const TetMesh& rest, const ElementFace& at) {
  const auto& nodes = FACE_NODES[at.face];
  const Vec3 &A = rest.nodes[rest.elements[at.element][nodes[0]]], &B = rest.nodes[rest.elements[at.element][nodes[1]]],
             &C = rest.nodes[rest.elements[at.element][nodes[2]]];
  return 0.5 * (B - A).cross(C - A).norm();
}

std::vector<Vec3> tractionForces(const CutMesh& mesh, const std::vector<ElementFace>& faces, const Vec3& traction) {
  std::vector<Vec3> forces(mesh.numCopies(), Vec3::Zero());
  for (const ElementFace& at : faces) {
    const double area = areaAtRest(mesh.mesh(), at);
    forEachOwner(mesh, at, [&](const Part& part, const Vec3& shares) {
      for (int i = 0; i < 3; ++i) forces[part.copies[FACE_NODES[at.face][i]]] += shares[i] * area * traction;
    });
  }
  return forces;
}

}  // namespace

Loads::Loads(const CutMesh& mesh, std::vector<Load> loads)
    : mesh_(mesh), loads_(std::move(loads)), tractions_(loads_.size()), pressed_(loads_.size()) {
  for (const Load& load : loads_) {
    faces_.push_back(boundaryFacesAt(load.place, mesh.mesh(), mesh.topology()));
    any_presses_ = any_presses_ || load.pressure != 0;
  }
}

void Loads::topologyChanged() {
  for (std::size_t l = 0; l < loads_.size(); ++l) {
    if (!loads_[l].traction.isZero(0)) tractions_[l] = tractionForces(mesh_, faces_[l], loads_[l].traction);
    pressed_[l].clear();
    if (loads_[l].pressure == 0) continue;
    for (const ElementFace& at : faces_[l])
      forEachOwner(mesh_, at, [&](const Part& part, const Vec3& shares) {
        const auto& [a, b, c] = FACE_NODES[at.face];
        pressed_[l].push_back({{part.copies[a], part.copies[b], part.copies[c]}, shares});
      });
  }
}

void Loads::addTo(double time, const std::vector<Vec3>& x, std::vector<Vec3>* forces) const {
  for (std::size_t l = 0; l < loads_.size(); ++l) {
    const double ramp = loads_[l].ramp;
    const double share = ramp > 0 ? std::min(1.0, time / ramp) : 1;
    for (std::size_t c = 0; c < tractions_[l].size(); ++c) (*forces)[c] += share * tractions_[l][c];
    for (const auto& [copies, shares] : pressed_[l]) {
      const Vec3 &A = x[copies[0]], &B = x[copies[1]], &C = x[copies[2]];
      const Vec3 force = -0.5 * share * loads_[l].pressure * (B - A).cross(C - A);
      for (int i = 0; i < 3; ++i) (*forces)[copies[i]] += shares[i] * force;
    }
  }
}

}  // namespace incision
