// Forces of a cutting edge in a step.
#include "incision/tool/blade/cutting_edge.h"

namespace incision {
namespace {

/// An edge that has gone back from where it cut by this, in elements, and is in tissue still, cuts in a new direction.
constexpr double TURNED = 0.25;

/// An edge that has not begun to cut bears no more than this many times what it takes to begin: the force of an
/// element is shared among its stations as its nodes have it, and one step may bring more than what is missing.
constexpr double UNEVEN = 4;

}  // namespace

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
  const double most = station.waits ? UNEVEN * (station.most + station.onset) : station.most;
  trial.yields = station.stiffest * cuts > most;
  if (trial.yields) {
    // What is cut in the step is the slip beyond that of the spring: two in a row.
    const double soft = 1 + station.viscous / station.stiffest;
    trial.steepness = station.viscous / soft;
    trial.cuts_stiffness = (most / soft + trial.steepness * cuts) / cuts;
  }
  if (station.is_free) trial.cuts_stiffness = trial.steepness = 0;
  trial.slides = station.stiffest * beside > station.most_along;
  if (trial.slides) trial.beside_stiffness = station.most_along / beside;
  return trial;
}

void CuttingEdge::takeBounds(Span<const Vec3> moved, Span<const double> share) {
  int i = 0;
  for (Station& station : stations_) {
    if (station.tissue.count == 0) continue;
    if (share[i] > 0) takeBound(moved[i], share[i], &station);
    ++i;
  }
}

/// Friction along the edge may be as large as the force across it allows. What has been cut does not push back.
void CuttingEdge::takeBound(const Vec3& moved, double share, Station* station) const {
  station->is_free = false;
  const Trial trial = tryAt(*station, moved);
  const Vec3 forward = station->outward == 0 ? station->start.forward : Vec3(station->outward * direction_);
  station->is_free = trial.cuts.dot(forward) < 0;
  // The stations of the edge take what is across a tip.
  const bool drags = !station->is_free && station->outward == 0;
  const double most = drags ? friction_ * trial.cuts_stiffness * trial.cuts.norm() : 0;
  station->most_along += share * (most - station->most_along);
}

/// The force of what cuts descends from ½ k a² that goes on from the cutting force on evenly, or with a viscosity as a
/// parabola, and the friction beside it from one that goes on evenly from its bound on.
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
    Mat3 stiffness = trial.cuts_stiffness * cuts + trial.beside_stiffness * beside;
    if (trial.steepness > 0)
      stiffness += trial.steepness / trial.cuts.squaredNorm() * trial.cuts * trial.cuts.transpose();
    springs[i].set(stiffness, trial.cuts_stiffness * trial.cuts + trial.beside_stiffness * trial.beside, moved[i]);
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
    stations_[i].force = trial.cuts_stiffness * trial.cuts.norm();
    if (trial.yields && !stations_[i].is_free && !stations_[i].waits) station.forward = trial.cuts.normalized();
    if (!stations_[i].is_free) continue;
    station.slip = trial.cuts;
    if (trial.cuts.norm() >= TURNED * size_) station = {Vec3::Zero(), Vec3::Zero(), station.entered};
  }
  if (has_onset_) enterWhereReached();
}

}  // namespace incision
