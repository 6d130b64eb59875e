#include <algorithm>
#include <cmath>

#include "incision/base/parallel.h"
#include "incision/cut/point.h"
#include "incision/fracture/growth.h"

namespace incision {
namespace {

/// Forward in the crack's plane, across its line.
Vec3 forward(const Front& front, const Vec3& behind) {
  const Vec3 n = front.behind.normalized(), away = middleOf(front) - behind;
  return away - n.dot(away) * n;
}

bool haveMet(const GrowingCrack& a, const GrowingCrack& b) {
  return std::any_of(a.phi.begin(), a.phi.end(), [&](const auto& known) { return b.phi.count(known.first) > 0; });
}

}  // namespace

bool CrackGrowth::hasGrown(const Fringe& fringe, const CutMesh& mesh) const {
  return memory_.cracks.at(fringe.crack).reached.count(mesh.parts()[fringe.behind].element) > 0;
}

std::vector<CrackResult> CrackGrowth::fuse(double time, const CutMesh& mesh, const std::vector<Vec3>& x) {
  const auto grown = [&](const Fringe& fringe) { return hasGrown(fringe, mesh); };
  if (!fuses() || settings_.fuse_angle <= 0 || memory_.cracks.cracks.size() < 2) return {};
  if (std::none_of(fringes_.begin(), fringes_.end(), grown)) return {};
  std::vector<Front> fronts;
  for (const Fringe& fringe : fringes_) fronts.push_back(frontOf(fringe, memory_.cracks.at(fringe.crack), mesh, x));

  std::vector<CrackResult> events;
  for (std::size_t i = 0; i < fringes_.size(); ++i) {
    if (!grown(fringes_[i])) continue;
    for (std::size_t j = 0; j < fringes_.size(); ++j) {
      const int crack = fringes_[i].crack, other = fringes_[j].crack;
      if (memory_.cracks.survivorOf(crack) == memory_.cracks.survivorOf(other)) continue;
      const Vec3 a = middleOf(fronts[i]), b = middleOf(fronts[j]), n = fronts[i].behind.normalized();
      const double cosine = n.dot(fronts[j].behind.normalized());
      if ((a - b).norm() > settings_.fuse_distance || std::abs(cosine) < std::cos(settings_.fuse_angle)) continue;
      if (haveMet(memory_.cracks.at(crack), memory_.cracks.at(other))) continue;  // they run into each other instead
      CrackResult event;
      event.time = time;
      event.change = CrackChange::FUSED;
      event.crack = std::min(crack, other);
      event.other = std::max(crack, other);
      event.where = (a + b) / 2;
      event.normal = n;
      events.push_back(event);
      ++version_;
      memory_.cracks.join(event.crack, event.other, cosine < 0 ? -1 : 1);
    }
  }
  return events;
}

/// For each fringe, the nearest point of another crack's face in the same piece that lies ahead within `fuse_distance`.
/// Of two fringes that close, that of the crack with the higher number rests while the other runs, or they would cut
/// out what lies between them.
void CrackGrowth::findTargets(const CutMesh& mesh, const std::vector<Vec3>& x, const std::vector<int>& piece) {
  const auto pieceOf = [&](int part) { return piece[mesh.parts()[part].copies[0]]; };
  parallelFor(static_cast<int>(fringes_.size()), mesh.threads(), [&](int i) {
    const Fringe& fringe = fringes_[i];
    const Front front = frontOf(fringe, memory_.cracks.at(fringe.crack), mesh, x);
    const Vec3 ahead = forward(front, at(mesh.parts()[fringe.behind], Barycentric::Constant(0.25), x));
    double nearest = settings_.fuse_distance;
    targets_[i] = {middleOf(front), std::nullopt, false, false};
    for (const CrackFace& face : faces_) {
      if (face.crack == fringe.crack || pieceOf(face.part) != pieceOf(fringe.ahead)) continue;
      const Vec3 to = at(mesh.parts()[face.part], face.point, x) - targets_[i].middle;
      if (to.norm() > nearest || to.dot(ahead) < 0) continue;
      nearest = to.norm();
      targets_[i].point = targets_[i].middle + to;
    }
    targets_[i].runs = targets_[i].point && hasGrown(fringe, mesh);
  });
  for (std::size_t i = 0; i < fringes_.size(); ++i)
    for (std::size_t j = 0; j < fringes_.size(); ++j)
      if (targets_[j].runs && fringes_[j].crack < fringes_[i].crack &&
          (targets_[i].middle - targets_[j].middle).norm() < settings_.fuse_distance)
        targets_[i].rests = true;
  for (Target& target : targets_) target.runs = target.runs && !target.rests;
}

}  // namespace incision
