#include "incision/tool/blade/cutting_edge.h"

#include <algorithm>
#include <cmath>

#include "incision/cut/cut_here.h"
namespace incision {
namespace {

/// The edge carries the tissue along by k = EDGE_STIFFNESS E a metre: it slips by F_c/k before it cuts, a twentieth of
/// the length F_c/E by which the tissue itself gives way. More costs iterations.
constexpr double EDGE_STIFFNESS = 20;

constexpr double MAX_STATIONS = 256;

/// What resists an edge in tissue is looked for this far before it, in elements: at the edge itself it would be what it
/// is just leaving. Where there is no tissue so far on, it comes out, and what it leaves is all there is.
constexpr double LEAD = 0.2;

/// An edge that moves across itself by less than this in a step, in elements, goes in no direction: rounding.
constexpr double STILL = 1e-9;

Vec3 atStation(const Edge& edge, double share) { return edge[0] + share * (edge[1] - edge[0]); }

double stationCount(const Edge& edge, double size) {
  return std::clamp(std::ceil(STATIONS_PER_ELEMENT * (edge[1] - edge[0]).norm() / size), 1.0, MAX_STATIONS);
}

}  // namespace

CuttingEdge::CuttingEdge(const EdgeOfTool& edge, ToolInStep* tool, const Ties& ties, const Stroke& stroke,
                         NearParts* near, const Materials& materials, const CutMesh& mesh)
    : resistances_(inRegions(edge.resistance, materials.regions())),
      friction_(edge.friction),
      group_(edge.group),
      edge_(edge.edge),
      tool_(tool),
      ties_(ties),
      stroke_(stroke),
      near_parts_(near),
      materials_(materials),
      size_(materials.meanSize()),
      skin_(mesh.mesh(), mesh.topology()),
      share_((edge_[1] - edge_[0]).norm() / stationCount(edge_, size_)),
      fronts_(edge.fronts) {
  memory_.resize(static_cast<std::size_t>(stationCount(edge_, size_)) + 2);
  for (const CuttingResistance& in_region : resistances_) {
    resists_ = resists_ || in_region.force > 0 || in_region.viscosity > 0 || in_region.onset > 0;
    has_onset_ = has_onset_ || in_region.onset > 0;
  }
}

void CuttingEdge::leave() {
  memory_.assign(memory_.size(), StationMemory());
  in_tissue_ = false;
  depth_ = 0;
}

void CuttingEdge::scaleCuttingForce(double factor) {
  if (factor == 0) leave();
  force_factor_ = factor;
}

bool CuttingEdge::begin(const StepStart& start, std::vector<Spring>* springs) {
  in_tissue_ = presses_ = false;
  depth_ = 0;
  if (!tool_->in_place || !tool_->active) return false;
  const RigidMotion& motion = tool_->groups[static_cast<std::size_t>(group_)];
  const Edge from = placed(edge_, motion.at(start.span.from)), to = placed(edge_, motion.at(start.span.to));
  direction_ = (to[1] - to[0]).normalized();
  findNear(from, start);
  stations_.resize(memory_.size());
  const std::size_t evenly = stations_.size() - 2;
  bool resists = false;
  for (std::size_t i = 0; i < stations_.size(); ++i) {
    double at = (static_cast<double>(i) + 0.5) / static_cast<double>(evenly);
    stations_[i] = Station();
    stations_[i].start = memory_[i];
    stations_[i].front = share_;
    if (i >= evenly) {
      at = static_cast<double>(i - evenly);
      stations_[i].front = fronts_[i - evenly];
      stations_[i].outward = i == evenly ? -1 : 1;
    }
    const Vec3 point = atStation(from, at);
    stations_[i].drift = atStation(to, at) - point;
    if (stations_[i].front > 0) beginStation(point, start, &stations_[i]);
    const bool forgets = !memory_[i].slip.isZero(0) || !memory_[i].forward.isZero(0) || memory_[i].entered;
    presses_ = presses_ || stations_[i].tissue.count > 0;
    resists = resists || forgets;
  }
  enterTogether();
  for (const Station& station : stations_)
    if (station.tissue.count > 0) springs->push_back(station.tissue);
  return (resists || presses_) && force_factor_ > 0 && resists_;
}

void CuttingEdge::findNear(const Edge& edge, const StepStart& start) {
  Eigen::AlignedBox3d reach(edge[0]);
  reach.extend(edge[1]);
  reach = {reach.min().array() - LEAD * size_, reach.max().array() + LEAD * size_};
  near_.clear();
  const std::vector<Part>& parts = start.mesh.parts();
  for (const int p : near_parts_->find(reach, 0, start.motion.x))
    if (reach.intersects(boxOf(parts[p], start.motion.x))) near_.push_back({p, {parts[p], start.motion.x}});
}

/// Finds what resists at the station, or a little before it.
void CuttingEdge::beginStation(const Vec3& point, const StepStart& start, Station* station) {
  const Vec3 across = rejected(station->drift, direction_);
  const double moved = across.norm();
  Swept swept = {size_ * direction_, Vec3::Zero()};
  if (moved > STILL * size_) swept[1] = size_ / moved * across;
  const std::optional<Found> here = findTissue(point, swept, start.mesh);
  if (here) depth_ = std::max(depth_, here->depth);
  in_tissue_ = in_tissue_ || here;
  const bool has_cut = !station->start.forward.isZero(0);
  Vec3 forward = station->outward * direction_;
  if (station->outward == 0)
    forward = has_cut ? station->start.forward
                      : rejected(station->start.slip + station->drift, direction_).stableNormalized();
  std::optional<Found> ahead;
  if (here || has_cut) ahead = findTissue(point + LEAD * size_ * forward, swept, start.mesh);
  if (!ahead && !here) {
    station->start = {Vec3::Zero(), Vec3::Zero(), station->start.entered && isInElement(point)};
    return;
  }
  // Before what another edge has parted already there is still what it is leaving.
  const bool leaves = here && (!ahead || ahead->tissue.count == 0);
  const Found& found = leaves ? *here : *ahead;
  station->tissue = found.tissue;
  station->stiffest = EDGE_STIFFNESS * materials_.youngModulus(found.element) * station->front;
  takeResistance(found.element, start.span.time_step, station);
}

/// What it takes to cut in an element.
void CuttingEdge::takeResistance(int element, double time_step, Station* station) const {
  const CuttingResistance& resistance = resistances_[materials_.regions().of(element)];
  station->most = force_factor_ * resistance.force * station->front;
  station->onset = force_factor_ * resistance.onset * station->front;
  station->viscous = force_factor_ * resistance.viscosity * station->front / time_step;
}

/// Whether a part is where a point is, or has come away from there: its element as the part sees it, taken whole.
bool CuttingEdge::isInElement(const Vec3& point) const {
  return std::any_of(near_.begin(), near_.end(), [&](const Near& near) {
    return near.frame.invertible() && near.frame.toElement(point).minCoeff() >= -OUTSIDE;
  });
}

/// Whether the point of a part lies in a cut along which the edge goes.
bool CuttingEdge::isInSlit(const Vec3& point, const Swept& swept, const Near& near, const CutMesh& mesh) const {
  const int element = mesh.parts()[near.part].element;
  const auto resting = [&](const Vec3& y) { return atRest(mesh, element, near.frame.toElement(y)); };
  CutSought sought;
  sought.point = resting(point);
  sought.normal = (resting(point + swept[0]) - sought.point).cross(resting(point + swept[1]) - sought.point);
  sought.distance = SLIT_REACH * materials_.size(element);
  sought.cosine = SLIT_COSINE;
  sought.growing = stroke_.crack();
  return isCutHere(mesh, near.part, sought);
}

std::optional<CuttingEdge::Found> CuttingEdge::findTissue(const Vec3& point, const Swept& swept, const CutMesh& mesh) {
  for (const auto& [p, frame] : near_) {
    const Part& part = mesh.parts()[p];
    if (!frame.invertible()) continue;
    const Barycentric b = frame.toElement(point);
    if (b.minCoeff() < -OUTSIDE) continue;
    const Ties::Ahead ahead = ties_.ahead(part.element, b);
    if (!ahead.section && !encloses(mesh.polytope(p), b)) continue;
    Found found;
    found.element = part.element;
    const auto share = [&](int side, double weight) {
      for (int I = 0; I < 4; ++I) found.tissue.add(mesh.parts()[side].copies[I], weight * b[I]);
    };
    for (int I = 0; I < 4; ++I) found.depth += b[I] * skin_.at(mesh.copyNode(part.copies[I]));
    if (ahead.unswept) {
      share(ahead.section->plus, 0.5);
      share(ahead.section->minus, 0.5);
    } else if (!ahead.section && !isInSlit(point, swept, {p, frame}, mesh)) {
      share(p, 1);
    }
    return found;
  }
  return std::nullopt;
}

}  // namespace incision
