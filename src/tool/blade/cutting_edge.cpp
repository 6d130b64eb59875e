#include "incision/tool/blade/cutting_edge.h"

#include <algorithm>
#include <cmath>

#include "incision/cut/cut_here.h"
namespace incision {
namespace {

/// The edge carries the tissue along by k = EDGE_STIFFNESS E a metre: it slips by F_c/k before it cuts, a twentieth of
/// the length F_c/E by which the tissue itself gives way. More costs iterations.
constexpr double EDGE_STIFFNESS = 20;

/// Stations an element: what the force is off where the edge comes out of the tissue is half a station.
constexpr double STATIONS_PER_ELEMENT = 8;
constexpr double MAX_STATIONS = 256;

/// What resists an edge in tissue is looked for this far before it, in elements: at the edge itself it would be what it
/// is just leaving. Where there is no tissue so far on, it comes out, and what it leaves is all there is.
constexpr double LEAD = 0.2;

/// An edge that moves across itself by less than this in a step, in elements, goes in no direction: rounding.
constexpr double STILL = 1e-9;

/// An edge that has gone back from where it cut by this, in elements, and is in tissue still, cuts in a new direction.
constexpr double TURNED = 0.25;

Vec3 atStation(const Edge& edge, double share) { return edge[0] + share * (edge[1] - edge[0]); }

double stationCount(const Edge& edge, double size) {
  return std::clamp(std::ceil(STATIONS_PER_ELEMENT * (edge[1] - edge[0]).norm() / size), 1.0, MAX_STATIONS);
}

Vec3 rejected(const Vec3& vector, const Vec3& direction) { return vector - vector.dot(direction) * direction; }

}  // namespace

CuttingEdge::CuttingEdge(const EdgeOfTool& edge, ToolInStep* tool, const Ties& ties, const Stroke& stroke,
                         NearParts* near, const Materials& materials, const CutMesh& mesh)
    : cutting_forces_(materials.regions().values(edge.cutting_force, &RegionSettings::cutting_force)),
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
  in_tissue_ = false;
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
    const bool forgets = !memory_[i].slip.isZero(0) || !memory_[i].forward.isZero(0);
    resists = resists || stations_[i].tissue.count > 0 || forgets;
  }
  for (const Station& station : stations_)
    if (station.tissue.count > 0) springs->push_back(station.tissue);
  return resists && force_factor_ > 0 && *std::max_element(cutting_forces_.begin(), cutting_forces_.end()) > 0;
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
    station->start = StationMemory();
    return;
  }
  // Before what another edge has parted already there is still what it is leaving.
  const bool leaves = here && (!ahead || ahead->tissue.count == 0);
  const Found& found = leaves ? *here : *ahead;
  station->tissue = found.tissue;
  station->stiffest = EDGE_STIFFNESS * materials_.youngModulus(found.element) * station->front;
  station->most = force_factor_ * cutting_forces_[materials_.regions().of(found.element)] * station->front;
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

/// What of a station's slip cuts: that across the edge; of a tip, which pushes outward alone, that along it.
Vec3 CuttingEdge::cutting(const Station& station, const Vec3& slip) const {
  return station.outward == 0 ? rejected(slip, direction_) : Vec3(slip.dot(direction_) * direction_);
}

CuttingEdge::Trial CuttingEdge::tryAt(const Station& station, const Vec3& moved) const {
  const Vec3 slip = station.start.slip + station.drift - moved;
  Trial trial;
  trial.cuts = cutting(station, slip);
  trial.beside = slip - trial.cuts;
  trial.cuts_stiffness = trial.beside_stiffness = station.stiffest;
  const double cuts = trial.cuts.norm(), beside = trial.beside.norm();
  trial.yields = station.stiffest * cuts > station.most;
  if (trial.yields) trial.cuts_stiffness = station.most / cuts;
  if (station.is_free) trial.cuts_stiffness = 0;
  trial.slides = station.stiffest * beside > station.most_along;
  if (trial.slides) trial.beside_stiffness = station.most_along / beside;
  return trial;
}

/// Friction along the edge may be as large as the force across it allows. What has been cut does not push back.
void CuttingEdge::takeBounds(Span<const Vec3> moved, double share) {
  int i = 0;
  for (Station& station : stations_) {
    if (station.tissue.count == 0) continue;
    station.is_free = false;
    const Trial trial = tryAt(station, moved[i++]);
    const Vec3 forward = station.outward == 0 ? station.start.forward : Vec3(station.outward * direction_);
    station.is_free = trial.cuts.dot(forward) < 0;
    // The stations of the edge take what is across a tip.
    const bool drags = !station.is_free && station.outward == 0;
    const double most = drags ? friction_ * trial.cuts_stiffness * trial.cuts.norm() : 0;
    station.most_along += share * (most - station.most_along);
  }
}

/// The force of what cuts descends from ½ k a² that goes on evenly from the cutting force on, and so does the friction
/// beside it from its bound on.
void CuttingEdge::update(Span<const Vec3> moved, Span<Spring> springs) {
  int i = 0;
  for (const Station& station : stations_) {
    if (station.tissue.count == 0) continue;
    const Trial trial = tryAt(station, moved[i]);
    const Mat3 lengthwise = direction_ * direction_.transpose(), crosswise = Mat3::Identity() - lengthwise;
    Mat3 cuts = station.outward == 0 ? crosswise : lengthwise;
    Mat3 beside = station.outward == 0 ? lengthwise : crosswise;
    if (trial.yields) cuts -= trial.cuts * trial.cuts.transpose() / trial.cuts.squaredNorm();
    if (trial.slides) beside -= trial.beside * trial.beside.transpose() / trial.beside.squaredNorm();
    springs[i].set(trial.cuts_stiffness * cuts + trial.beside_stiffness * beside,
                   trial.cuts_stiffness * trial.cuts + trial.beside_stiffness * trial.beside, moved[i]);
    ++i;
  }
}

void CuttingEdge::accept(const StepSpan& span, Span<const Vec3> moved, const Motion& /*end*/, const Wrench& felt) {
  tool_->feel(group_, span, felt);
  int next = 0;
  for (std::size_t i = 0; i < stations_.size(); ++i) {
    StationMemory& station = memory_[i];
    station = stations_[i].start;
    if (stations_[i].tissue.count == 0) continue;
    const Trial trial = tryAt(stations_[i], moved[next++]);
    station.slip = (trial.cuts_stiffness * trial.cuts + trial.beside_stiffness * trial.beside) / stations_[i].stiffest;
    if (trial.yields && !stations_[i].is_free) station.forward = trial.cuts.normalized();
    if (!stations_[i].is_free) continue;
    station.slip = trial.cuts;
    if (trial.cuts.norm() >= TURNED * size_) station = StationMemory();
  }
}

}  // namespace incision
