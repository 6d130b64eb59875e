#include "incision/tool/blade/cutting_edge.h"

#include <algorithm>
#include <cmath>

namespace incision {
namespace {

/// The edge holds the tissue by k = EDGE_STIFFNESS E a metre: it slips by F_c/k before it cuts, a twentieth of the
/// length F_c/E by which the tissue itself gives way. More costs iterations.
constexpr double EDGE_STIFFNESS = 20;

/// Stations an element: what the force is off where the edge comes out of the tissue is half a station.
constexpr double STATIONS_PER_ELEMENT = 8;
constexpr double MAX_STATIONS = 256;

/// Change of a stiffness, as a share of it, that takes another solve.
constexpr double STIFFNESS_TOLERANCE = 0.005;

/// A point is in an element up to this beyond its faces, in its own coordinates: rounding.
constexpr double OUTSIDE = 1e-9;

/// What resists an edge in tissue is looked for this far before it, in elements: at the edge itself it would be what it
/// is just leaving. Where there is no tissue so far on, it comes out, and what it leaves is all there is.
constexpr double LEAD = 0.2;

/// An edge this near to the face of an old cut, in elements, runs in that cut.
constexpr double IN_A_SLIT = 0.05;

/// An edge that has gone back from where it cut by this, in elements, and is in tissue still, cuts in a new direction.
constexpr double TURNED = 0.25;

Vec3 atStation(const Edge& edge, double share) { return edge[0] + share * (edge[1] - edge[0]); }

/// Whether a point of the element lies in the part.
bool holds(const Polytope& polytope, const Barycentric& point) {
  return std::all_of(polytope.facets.begin(), polytope.facets.end(), [&](const Facet& facet) {
    const auto in_affine = [](const Barycentric& b) -> Vec3 { return b.tail<3>(); };
    const Vec3 out = vectorArea(polytope, facet, in_affine);
    return out.dot((point - polytope.corners[facet.corners[0]]).tail<3>()) <= OUTSIDE;
  });
}

/// Whether the point lies beside a face that some crack has cut.
bool besideCut(const CutMesh& mesh, int part, const Barycentric& point, double distance) {
  const Polytope& polytope = mesh.polytope(part);
  const int element = mesh.parts()[part].element;
  const auto resting = [&](const Barycentric& b) { return atRest(mesh, element, b); };
  return std::any_of(polytope.facets.begin(), polytope.facets.end(), [&](const Facet& facet) {
    if (facet.crack < 0) return false;
    const Vec3 out = vectorArea(polytope, facet, resting).stableNormalized();
    return std::abs(out.dot(resting(point) - resting(polytope.corners[facet.corners[0]]))) < distance;
  });
}

double meanSize(const CutMesh& mesh) {
  const int elements = static_cast<int>(mesh.mesh().elements.size());
  double volume = 0;
  for (int e = 0; e < elements; ++e) volume += elementVolume(mesh.mesh(), e);
  return std::cbrt(6 * volume / elements);
}

}  // namespace

CuttingEdge::CuttingEdge(const ToolSettings& settings, double young_modulus, const CutMesh& mesh)
    : cutting_force_(settings.cutting_force),
      friction_(settings.friction),
      young_modulus_(young_modulus),
      size_(meanSize(mesh)),
      skin_(mesh.mesh(), mesh.topology()) {}

void CuttingEdge::begin(const Edge& from, const Edge& to, const CutMesh& mesh, const std::vector<Vec3>& x,
                        const Ties& ties) {
  const double length = (to[1] - to[0]).norm();
  const double count = std::clamp(std::ceil(STATIONS_PER_ELEMENT * length / size_), 1.0, MAX_STATIONS);
  stations_.resize(static_cast<std::size_t>(count));
  direction_ = (to[1] - to[0]) / length;
  share_ = length / count;
  in_tissue_ = held_ = false;
  depth_ = 0;
  Eigen::AlignedBox3d reach(from[0]);
  reach.extend(from[1]);
  reach = {reach.min().array() - LEAD * size_, reach.max().array() + LEAD * size_};
  std::vector<Near> near;
  for (std::size_t p = 0; p < mesh.parts().size(); ++p)
    if (reach.intersects(boxOf(mesh.parts()[p], x))) near.push_back({static_cast<int>(p), {mesh.parts()[p], x}});
  for (std::size_t i = 0; i < stations_.size(); ++i) {
    const double at = (static_cast<double>(i) + 0.5) / count;
    Station& station = stations_[i];
    const Vec3 point = atStation(from, at);
    station.drift = atStation(to, at) - point;
    station.held = Coupling();
    const std::optional<Found> here = findTissue(point, near, mesh, ties);
    if (here) depth_ = std::max(depth_, here->depth);
    in_tissue_ = in_tissue_ || here;
    const bool has_cut = !station.forward.isZero(0);
    const Vec3 way = station.slip + station.drift;
    const Vec3 forward = has_cut ? station.forward : (way - way.dot(direction_) * direction_).stableNormalized();
    std::optional<Found> ahead;
    if (here || has_cut) ahead = findTissue(point + LEAD * size_ * forward, near, mesh, ties);
    if (ahead || here) {
      station.held = (ahead ? ahead : here)->held;
    } else {
      station.slip.setZero();
      station.forward.setZero();
    }
    held_ = held_ || (station.held.count > 0 && cutting_force_ > 0);
  }
}

void CuttingEdge::leave() {
  stations_.clear();
  held_ = in_tissue_ = false;
  depth_ = 0;
}

std::optional<CuttingEdge::Found> CuttingEdge::findTissue(const Vec3& point, const std::vector<Near>& near,
                                                          const CutMesh& mesh, const Ties& ties) {
  for (const auto& [p, frame] : near) {
    const Part& part = mesh.parts()[p];
    if (!frame.invertible()) continue;
    const Barycentric b = frame.toElement(point);
    if (b.minCoeff() < -OUTSIDE) continue;
    const Ties::Ahead ahead = ties.ahead(part.element, b);
    if (!ahead.section && !holds(mesh.polytope(p), b)) continue;
    Found found;
    const auto hold = [&](int side, double weight) {
      for (int I = 0; I < 4; ++I) found.held.add(mesh.parts()[side].copies[I], weight * b[I]);
    };
    for (int I = 0; I < 4; ++I) found.depth += b[I] * skin_.at(mesh.copyNode(part.copies[I]));
    if (ahead.unswept) {
      hold(ahead.section->plus, 0.5);
      hold(ahead.section->minus, 0.5);
    } else if (!ahead.section && !besideCut(mesh, p, b, IN_A_SLIT * size_)) {
      hold(p, 1);
    }
    return found;
  }
  return std::nullopt;
}

CuttingEdge::Trial CuttingEdge::tryAt(const Station& station, double time_step, const std::vector<Vec3>& v_end) const {
  Vec3 rate = Vec3::Zero();
  for (int i = 0; i < station.held.count; ++i) rate += station.held.weights[i] * v_end[station.held.copies[i]];
  Trial trial;
  trial.slip = station.slip + station.drift - time_step * rate;
  const Vec3 along = trial.slip.dot(direction_) * direction_, across = trial.slip - along;
  trial.across = trial.along = EDGE_STIFFNESS * young_modulus_ * share_;
  const double most = cutting_force_ * share_;
  trial.yields = trial.across * across.norm() > most;
  if (trial.yields) trial.across = most / across.norm();
  if (across.dot(station.forward) < 0) trial.across = 0;
  // Secants: so the system stays symmetric.
  const double most_along = friction_ * trial.across * across.norm();
  if (trial.along * along.norm() > most_along) trial.along = most_along / along.norm();
  return trial;
}

bool CuttingEdge::update(double time_step, const std::vector<Vec3>& v_end, std::vector<Coupling>* couplings) {
  bool changed = false;
  const auto differs = [](double a, double b) { return std::abs(a - b) > STIFFNESS_TOLERANCE * std::max(a, b); };
  for (Station& station : stations_) {
    if (station.held.count == 0) continue;
    const Trial trial = tryAt(station, time_step, v_end);
    changed = changed || differs(trial.across, station.across) || differs(trial.along, station.along);
    station.across = trial.across;
    station.along = trial.along;
    if (trial.across == 0) continue;
    Coupling coupling = station.held;
    const Mat3 along = direction_ * direction_.transpose();
    coupling.stiffness = trial.across * (Mat3::Identity() - along) + trial.along * along;
    coupling.force = coupling.stiffness * (station.slip + station.drift);
    coupling.tool = true;
    couplings->push_back(coupling);
  }
  return changed;
}

void CuttingEdge::accept(double time_step, const std::vector<Vec3>& v_end) {
  const double stiffest = EDGE_STIFFNESS * young_modulus_ * share_;
  for (Station& station : stations_) {
    if (station.held.count == 0) continue;
    const Trial trial = tryAt(station, time_step, v_end);
    const Vec3 along = trial.slip.dot(direction_) * direction_, across = trial.slip - along;
    station.slip = trial.across / stiffest * across + trial.along / stiffest * along;
    if (trial.yields && trial.across > 0) station.forward = across.normalized();
    if (trial.across > 0) continue;
    station.slip = across;
    if (across.norm() < TURNED * size_) continue;
    station.slip.setZero();
    station.forward.setZero();
  }
}

}  // namespace incision
