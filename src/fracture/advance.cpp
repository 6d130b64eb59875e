#include <algorithm>
#include <cmath>

#include "incision/base/parallel.h"
#include "incision/cut/point.h"
#include "incision/fracture/front.h"
#include "incision/fracture/growth.h"

namespace incision {
namespace {

/// A growing crack passes every node at this share of its shortest edge or more: then it never runs along faces and
/// edges, so that it always ends on lines across faces, and it cuts off no slivers. What it strays by is small beside
/// the error of the stress in one element.
constexpr double CLEARANCE = 1e-2;

double clearOf(int node, double phi, const CutMesh& mesh) {
  return std::copysign(std::max(std::abs(phi), CLEARANCE * mesh.shortestEdge(node)), phi);
}

bool shareCopy(const Part& a, const Part& b) {
  return std::find_first_of(a.copies.begin(), a.copies.end(), b.copies.begin(), b.copies.end()) != a.copies.end();
}

/// No crack starts in a crack element. Its parts strain as the whole element does, so beside a crack's free face the
/// stress is noise: it would slice the element again and again, into slivers, and shatter the smallest fragments
/// without end.
bool isSplit(const CutMesh& mesh, int part) { return mesh.parts()[mesh.parts()[part].element].next >= 0; }

/// The mean of what several fringes want of one copy.
struct Wanted {
  double sum = 0;
  int count = 0;
};

}  // namespace

/// The most loaded part of a piece, and the most loaded one in which a crack may start.
struct CrackGrowth::PieceLoad {
  int worst = -1, start = -1;
  bool advances = false;
};

/// Finds the loading of the parts that may be beyond their strength, and of those that fringes are about to enter; of
/// the others it is known to be no more than they bear. Returns the largest share of the strength in any part that does
/// not wait.
double CrackGrowth::load(const Assembly& assembly, const std::vector<Vec3>& x, bool any_runs) {
  const bool any = stress_.findSuspects(assembly, x, strengths_, &looked_at_);
  if (!any && !any_runs) return 0;
  if (!any) looked_at_.assign(looked_at_.size(), 0);
  for (const Fringe& fringe : fringes_) looked_at_[fringe.ahead] = 1;
  stress_.update(assembly, x, looked_at_);
  const Regions& regions = assembly.materials().regions();
  parallelFor(static_cast<int>(loading_.size()), assembly.threads(), [&](int p) {
    const Strength& strength = strengths_[regions.of(assembly.mesh().parts()[p].element)];
    const bool counts = looked_at_[p] != 0 && !waits(assembly.mesh(), p);
    loading_[p] = counts ? rankine(stress_.smoothed()[p], strength) : Loading();
  });
  double largest = 0;
  for (const Loading& loading : loading_) largest = std::max(largest, loading.share);
  return largest;
}

std::vector<CrackGrowth::PieceLoad> CrackGrowth::mostLoaded(const CutMesh& mesh, const std::vector<int>& piece) const {
  std::vector<PieceLoad> pieces(*std::max_element(piece.begin(), piece.end()) + 1);
  const auto worse = [&](int p, int than) { return than < 0 || loading_[p].share > loading_[than].share; };
  for (int p = 0; p < static_cast<int>(loading_.size()); ++p) {
    if (!(loading_[p].share > 1)) continue;
    PieceLoad& load = pieces[piece[mesh.parts()[p].copies[0]]];
    if (worse(p, load.worst)) load.worst = p;
    if (!isSplit(mesh, p) && !isBeside(mesh, p) && memory_.barred.count(p) == 0 && worse(p, load.start)) load.start = p;
  }
  return pieces;
}

/// When the crack comes to the middle of the part ahead, if it does not have to wait for the stress [s].
double CrackGrowth::arrival(const Fringe& fringe, double time, const CutMesh& mesh, const std::vector<Vec3>& x) const {
  const Part &behind = mesh.parts()[fringe.behind], &ahead = mesh.parts()[fringe.ahead];
  const Barycentric middle = Barycentric::Constant(0.25);
  const auto& reached = memory_.cracks.at(fringe.crack).reached;
  const auto since = reached.find(behind.element);
  if (since == reached.end()) return time;
  return since->second + (at(ahead, middle, x) - at(behind, middle, x)).norm() / settings_.crack_speed;
}

std::vector<CrackAdvance> CrackGrowth::advances(double time, double time_step, const Assembly& assembly,
                                                const std::vector<Vec3>& x, const std::vector<int>& piece) {
  const CutMesh& mesh = assembly.mesh();
  if (fuses()) findTargets(mesh, x, piece);
  const bool any_runs = std::any_of(targets_.begin(), targets_.end(), [](const Target& target) { return target.runs; });
  if (!(load(assembly, x, any_runs) > 1) && !any_runs) return {};

  findBeside(mesh);
  std::vector<PieceLoad> pieces = mostLoaded(mesh, piece);
  std::vector<int> going;
  for (int i = 0; i < static_cast<int>(fringes_.size()); ++i) {
    const Part& ahead = mesh.parts()[fringes_[i].ahead];
    PieceLoad& load = pieces[piece[ahead.copies[0]]];
    const bool driven = loading_[fringes_[i].ahead].share > 1 || (fuses() && targets_[i].runs) ||
                        (load.worst >= 0 && shareCopy(mesh.parts()[load.worst], ahead));
    if (!driven || waits(mesh, fringes_[i].ahead)) continue;
    load.advances = true;
    if (arrival(fringes_[i], time, mesh, x) <= time && !(fuses() && targets_[i].rests)) going.push_back(i);
  }
  std::vector<CrackAdvance> result = grow(going, time - time_step, mesh, x);
  for (const PieceLoad& load : pieces)
    if (load.start >= 0 && !load.advances) result.push_back(start(load.start, time, mesh, x));
  return result;
}

/// φ at the far copy of the part ahead of a fringe.
double CrackGrowth::phiAhead(int fringe, const CutMesh& mesh, const std::vector<Vec3>& x) const {
  const Fringe& at = fringes_[fringe];
  const Front front = frontOf(at, memory_.cracks.at(at.crack), mesh, x);
  const Vec3 normal = fuses() && targets_[fringe].point ? normalTowards(front, *targets_[fringe].point)
                                                        : crackNormal(stress_.smoothed()[at.ahead]);
  return phiBeyond(front, normal, x[mesh.parts()[at.ahead].copies[at.face]]);
}

/// One element on from each of these fringes. Where several want φ of one copy it becomes their mean, so that all
/// elements round the copy see one surface.
std::vector<CrackAdvance> CrackGrowth::grow(const std::vector<int>& fringes, double earliest, const CutMesh& mesh,
                                            const std::vector<Vec3>& x) const {
  std::map<std::pair<int, int>, Wanted> wanted;   // of each surviving crack, at each copy
  std::map<int, std::map<int, double>> arrivals;  // of each crack, in each part
  for (int i : fringes) {
    const Fringe& fringe = fringes_[i];
    const int far = mesh.parts()[fringe.ahead].copies[fringe.face];
    if (memory_.cracks.at(fringe.crack).phi.count(far) == 0) {
      const double phi = phiAhead(i, mesh, x);
      if (!std::isfinite(phi)) continue;  // the face is flat
      Wanted& mean = wanted[{memory_.cracks.survivorOf(fringe.crack), far}];
      mean.sum += phi;
      ++mean.count;
    }
    const double arrives = std::max(earliest, arrival(fringe, earliest, mesh, x));
    const auto [known, first] = arrivals[fringe.crack].try_emplace(fringe.ahead, arrives);
    if (!first) known->second = std::min(known->second, arrives);
  }
  std::vector<CrackAdvance> advances;
  for (const auto& [number, parts] : arrivals) {
    CrackAdvance advance;
    advance.crack = number;
    for (const auto& [part, time] : parts) {
      advance.parts.push_back(part);
      advance.reached.push_back(time);
      if (loading_[part].share > advance.loading.share) advance.loading = loading_[part];
    }
    for (const auto& [at, mean] : wanted)
      if (at.first == memory_.cracks.survivorOf(number))
        advance.fresh.emplace_back(at.second, clearOf(mesh.copyNode(at.second), mean.sum / mean.count, mesh));
    advances.push_back(std::move(advance));
  }
  return advances;
}

CrackAdvance CrackGrowth::start(int part, double time, const CutMesh& mesh, const std::vector<Vec3>& x) const {
  CrackAdvance advance;
  advance.parts = {part};
  advance.reached = {time};
  advance.loading = loading_[part];
  const Vec3 n = crackNormal(stress_.smoothed()[part]), centroid = at(mesh.parts()[part], mesh.centroid(part), x);
  for (int c : mesh.parts()[part].copies)
    advance.fresh.emplace_back(c, clearOf(mesh.copyNode(c), n.dot(x[c] - centroid), mesh));
  return advance;
}

}  // namespace incision
