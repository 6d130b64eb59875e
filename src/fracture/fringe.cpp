#include "incision/fracture/fringe.h"

#include <algorithm>

namespace incision {
namespace {

/// Whether φ, known at the copies of the face alone, has both signs on what the part owns of it.
bool crosses(const GrowingCrack& crack, const CutMesh& mesh, int part, int face) {
  Eigen::Vector4d phi = Eigen::Vector4d::Zero();
  for (int I : FACE_NODES[face]) {
    const auto known = crack.phi.find(mesh.parts()[part].copies[I]);
    if (known == crack.phi.end()) return false;
    phi[I] = known->second;
  }
  const Polytope& polytope = mesh.polytope(part);
  const Facet* facet = polytope.onFace(face);
  if (!facet) return false;
  const double zero = ZERO_PHI * phi.cwiseAbs().maxCoeff();
  bool positive = false, negative = false;
  for (int c : facet->corners) {
    const double value = phi.dot(polytope.corners[c]);
    positive = positive || value > zero;
    negative = negative || value < -zero;
  }
  return positive && negative;
}

void addFringes(const CutMesh& mesh, const GrowingCrack& crack, int part, const Facet& facet,
                std::vector<Fringe>* fringes) {
  const int element = mesh.parts()[part].element;
  for (int face = 0; face < 4; ++face) {
    const int across = mesh.topology().neighbours[element][face];
    if (across < 0 || !reaches(facet, face, mesh.polytope(part))) continue;
    const int back = faceTowards(mesh.topology(), across, element);
    for (const FacePair& pair : mesh.facePairs(element, face))
      if (pair.part == part && !pair.severed_by && crack.refused.count(pair.other) == 0 &&
          crosses(crack, mesh, pair.other, back))
        fringes->push_back({facet.crack, part, pair.other, back});
  }
}

}  // namespace

int GrowingCracks::survivorOf(int number) const {
  const auto found = taken_in.find(number);
  return found == taken_in.end() ? number : found->second;
}

const GrowingCrack* GrowingCracks::find(int number) const {
  const auto found = cracks.find(survivorOf(number));
  return found == cracks.end() ? nullptr : &found->second;
}

void GrowingCracks::join(int number, int other, double sense) {
  const int survivor = survivorOf(number), gone = survivorOf(other);
  if (survivor == gone) return;
  GrowingCrack& kept = cracks.at(survivor);
  const GrowingCrack& joined = cracks.at(gone);
  for (const auto& [copy, phi] : joined.phi) kept.phi.emplace(copy, sense * phi);
  kept.reached.insert(joined.reached.begin(), joined.reached.end());
  kept.refused.insert(joined.refused.begin(), joined.refused.end());
  cracks.erase(gone);
  for (auto& [from, to] : taken_in)
    if (to == gone) to = survivor;
  taken_in[gone] = survivor;
}

bool reaches(const Facet& facet, int face, const Polytope& polytope) {
  return std::count_if(facet.corners.begin(), facet.corners.end(),
                       [&](int c) { return polytope.corners[c][face] == 0; }) >= 2;
}

int faceTowards(const MeshTopology& topology, int element, int across) {
  int face = 0;
  while (topology.neighbours[element][face] != across) ++face;
  return face;
}

std::optional<Eigen::Vector4d> phiAt(const GrowingCrack& crack, const Part& part) {
  Eigen::Vector4d phi;
  for (int I = 0; I < 4; ++I) {
    const auto known = crack.phi.find(part.copies[I]);
    if (known == crack.phi.end()) return std::nullopt;
    phi[I] = known->second;
  }
  return phi;
}

std::vector<Fringe> findFringes(const CutMesh& mesh, const GrowingCracks& cracks) {
  std::vector<Fringe> fringes;
  for (int p = 0; p < static_cast<int>(mesh.parts().size()); ++p) {
    if (mesh.parts()[p].detail < 0) continue;
    for (const Facet& facet : mesh.polytope(p).facets) {
      const GrowingCrack* crack = cracks.find(facet.crack);
      if (!crack) continue;
      const auto phi = phiAt(*crack, mesh.parts()[p]);
      if (phi && phi->dot(mesh.centroid(p)) > 0) addFringes(mesh, *crack, p, facet, &fringes);
    }
  }
  return fringes;
}

}  // namespace incision
