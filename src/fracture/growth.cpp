#include "incision/fracture/growth.h"

#include <Eigen/Geometry>
#include <algorithm>

#include "incision/cut/section.h"

namespace incision {
namespace {

/// The crack's new surface: its vector area and its centroid.
struct NewSurface {
  Vec3 area = Vec3::Zero(), centroid = Vec3::Zero();
};

/// The surface of the facets that the crack has made in these parts, seen from its negative side.
NewSurface newSurface(int crack, const std::vector<int>& parts, const CutMesh& mesh, const std::vector<Vec3>& x) {
  NewSurface surface;
  double sum = 0;
  for (int p : parts)
    for (const Facet& facet : mesh.polytope(p).facets) {
      if (facet.crack != crack) continue;
      const auto place = [&](std::size_t i) {
        return at(mesh.parts()[p], mesh.polytope(p).corners[facet.corners[i]], x);
      };
      const Vec3 base = place(0);
      for (std::size_t i = 2; i < facet.corners.size(); ++i) {
        const Vec3 b = place(i - 1), c = place(i), area = (c - base).cross(b - base) / 2;
        surface.area += area;
        surface.centroid += area.norm() * (base + b + c) / 3;
        sum += area.norm();
      }
    }
  if (sum > 0) surface.centroid /= sum;
  return surface;
}

std::vector<int> elementsOf(const std::vector<int>& parts, const CutMesh& mesh) {
  std::set<int> elements;
  for (int p : parts) elements.insert(mesh.parts()[p].element);
  return {elements.begin(), elements.end()};
}

}  // namespace

void CrackGrowth::topologyChanged(const Assembly& assembly, const std::vector<int>& touched) {
  ++version_;
  const CutMesh& mesh = assembly.mesh();
  inherit(mesh);
  memory_.waiting.resize(mesh.mesh().nodes.size(), 0);
  wait(touched);
  stress_.topologyChanged(assembly);
  strengths_ = strengthsOf(settings_, assembly.materials().regions());
  loading_.resize(mesh.parts().size());
  looked_at_.resize(mesh.parts().size());
  fringes_ = findFringes(mesh, memory_.cracks);
  if (fuses()) {
    faces_ = crackFaces(mesh);
    targets_.resize(fringes_.size());
  }
}

void CrackGrowth::stepTaken() {
  if (!memory_.any_waiting) return;
  ++version_;
  memory_.waiting.assign(memory_.waiting.size(), 0);
  memory_.any_waiting = false;
}

void CrackGrowth::wait(const std::vector<int>& nodes) {
  for (int node : nodes) memory_.waiting[node] = 1;
  memory_.any_waiting = memory_.any_waiting || !nodes.empty();
}

bool CrackGrowth::waits(const CutMesh& mesh, int part) const {
  if (!memory_.any_waiting) return false;
  const auto& nodes = mesh.mesh().elements[mesh.parts()[part].element];
  return std::any_of(nodes.begin(), nodes.end(), [&](int node) { return memory_.waiting[node] != 0; });
}

void CrackGrowth::findBeside(const CutMesh& mesh) {
  beside_.assign(mesh.numCopies(), 0);
  for (const Fringe& fringe : fringes_)
    for (int c : mesh.parts()[fringe.ahead].copies) beside_[c] = 1;
}

bool CrackGrowth::isBeside(const CutMesh& mesh, int part) const {
  const auto& copies = mesh.parts()[part].copies;
  return std::any_of(copies.begin(), copies.end(), [&](int c) { return beside_[c] != 0; });
}

std::optional<CrackField> CrackGrowth::field(const CrackAdvance& advance, const CutMesh& mesh) const {
  CrackField field;
  field.crack = advance.crack;
  for (int p : advance.parts)
    if (!waits(mesh, p)) field.parts.push_back(p);
  if (field.parts.empty()) return std::nullopt;
  field.phi.assign(mesh.numCopies(), 0);
  if (advance.crack) {
    const GrowingCrack& crack = memory_.cracks.at(*advance.crack);
    for (int p : field.parts)
      for (int c : mesh.parts()[p].copies)
        if (const auto known = crack.phi.find(c); known != crack.phi.end()) field.phi[c] = known->second;
  }
  for (const auto& [copy, phi] : advance.fresh) field.phi[copy] = phi;
  return field;
}

CrackResult CrackGrowth::inserted(double time, const CrackAdvance& advance, const CrackField& field,
                                  const Insertion& done, const CutMesh& mesh, const std::vector<Vec3>& x) {
  CrackResult event;
  event.time = time;
  event.change = advance.crack ? CrackChange::GREW : CrackChange::STARTED;
  event.crack = done.crack;
  event.kind = advance.loading.kind;
  event.stress = advance.loading.stress;
  event.elements = elementsOf(done.parts, mesh);
  const NewSurface surface = newSurface(done.crack, done.parts, mesh, x);
  event.where = surface.centroid;
  if (surface.area.norm() > 0) event.normal = surface.area.normalized();

  GrowingCrack& crack = remember(field, done, mesh);
  const std::set<int> split(done.parts.begin(), done.parts.end());
  for (std::size_t i = 0; i < advance.parts.size(); ++i)
    if (split.count(advance.parts[i]) > 0) crack.reached[mesh.parts()[advance.parts[i]].element] = advance.reached[i];
  // What a fringe could not split now, it never will.
  for (int p : field.parts)
    if (split.count(p) == 0) crack.refused.insert(p);
  return event;
}

CrackResult CrackGrowth::refused(double time, const CrackAdvance& advance) {
  ++version_;
  CrackResult event;
  event.time = time;
  event.crack = advance.crack.value_or(-1);
  event.change = CrackChange::STOPPED;
  event.kind = advance.loading.kind;
  event.stress = advance.loading.stress;
  std::set<int>& refused = advance.crack ? memory_.cracks.at(*advance.crack).refused : memory_.barred;
  refused.insert(advance.parts.begin(), advance.parts.end());
  const auto gone = [&](const Fringe& fringe) {
    return advance.crack && memory_.cracks.survivorOf(fringe.crack) == memory_.cracks.survivorOf(*advance.crack) &&
           refused.count(fringe.ahead) > 0;
  };
  fringes_.erase(std::remove_if(fringes_.begin(), fringes_.end(), gone), fringes_.end());
  if (fuses()) targets_.resize(fringes_.size());
  return event;
}

void CrackGrowth::adopt(const CrackField& field, const Insertion& done, const CutMesh& mesh) {
  remember(field, done, mesh);
}

/// Keeps φ at the copies that the split parts had before.
GrowingCrack& CrackGrowth::remember(const CrackField& field, const Insertion& done, const CutMesh& mesh) {
  ++version_;
  GrowingCrack& crack = memory_.cracks.cracks[memory_.cracks.survivorOf(done.crack)];
  const int before = static_cast<int>(field.phi.size());
  for (int p : done.parts)
    for (int c : mesh.parts()[p].copies) {
      const int old = c < before ? c : mesh.copyParent(c);
      crack.phi[old] = field.phi[old];
    }
  inherit(mesh);
  wait(done.touched);
  return crack;
}

/// New copies have φ of every crack from their parents.
void CrackGrowth::inherit(const CutMesh& mesh) {
  for (int& copy = memory_.known_copies; copy < mesh.numCopies(); ++copy)
    for (auto& [name, crack] : memory_.cracks.cracks)
      if (const auto parent = crack.phi.find(mesh.copyParent(copy)); parent != crack.phi.end()) {
        const double phi = parent->second;  // taken out first, since the next line may move what it points to
        crack.phi[copy] = phi;
      }
}

}  // namespace incision
