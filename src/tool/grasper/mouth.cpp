#include "incision/tool/grasper/mouth.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "incision/tool/grasper/spread_out.h"

namespace incision {
namespace {

/// How deep a point may have been pressed into a jaw, as a share of the jaw's thickness: contact lets it in by far
/// less, and what is nearer to the far side is not before the jaw.
constexpr double PRESSED = 0.25;

/// Points that stand for the room: what they can miss is smaller than a hundredth of it.
constexpr std::size_t MOUTH_POINTS = 384;

/// Lattice points in the box round each shape of a jaw from which the room before it is sought, and points on the way
/// from there to the other jaw.
constexpr double LATTICE = 1500;
constexpr int LAYERS = 3;

/// Steps of a walk by distances. One that passes a surface at a flat angle takes some tens.
constexpr int MOST_STEPS = 200;

/// A walk has come upon a jaw this near to it, as a share of how far the jaws may be apart.
constexpr double MET = 1e-6;

/// The corners of the box round a solid, in its own frame [m].
Eigen::AlignedBox3d boxRound(const Solid& solid) {
  Eigen::AlignedBox3d box;
  for (int k = 0; k < 3; ++k) {
    box.max()[k] = solid.reachAlong(Vec3::Unit(k));
    box.min()[k] = -solid.reachAlong(-Vec3::Unit(k));
  }
  return box;
}

/// Calls f for the middles of about LATTICE cells of a box, as near to cubes as they can be.
template <typename Function>
void overLattice(const Eigen::AlignedBox3d& box, const Function& f) {
  const Vec3 size = box.sizes();
  const double spacing = std::cbrt(size.prod() / LATTICE);
  Eigen::Vector3i cells;
  for (int k = 0; k < 3; ++k) cells[k] = std::clamp(static_cast<int>(std::ceil(size[k] / spacing)), 1, 100);
  for (int i = 0; i < cells[0]; ++i)
    for (int j = 0; j < cells[1]; ++j)
      for (int k = 0; k < cells[2]; ++k)
        f(Vec3(box.min() +
               size.cwiseProduct((Vec3(i, j, k).array() + 0.5).matrix().cwiseQuotient(cells.cast<double>()))));
}

}  // namespace

Mouth::Mouth(const JawLinks& links, double angle) : links_(links) {
  jaws_ = {placed(links, 1, angle), placed(links, links.groups() > 2 ? 2 : 0, angle)};
  pressed_ = std::numeric_limits<double>::infinity();
  for (const Jaw& jaw : jaws_)
    for (const Shape& shape : jaw) pressed_ = std::min(pressed_, PRESSED * shape.solid->thickness());
  for (const Shape& shape : jaws_[0]) reach_ = std::max(reach_, 2 * shape.solid->reach());
  std::vector<Vec3> room;
  for (const Vec3& inside : inFirstJaw()) {
    const Vec3 direction = links_.closing(inside).stableNormalized();
    if (direction.isZero(0)) continue;
    addRoomBefore(inside, direction, &room);
    addRoomBefore(inside, -direction, &room);
  }
  for (const int i : spreadOut(room, MOUTH_POINTS))
    if (isBetween(room[i])) points_.push_back(room[i]);
  for (const Vec3& point : points_) box_.extend(point);
}

Mouth::Jaw Mouth::placed(const JawLinks& links, int group, double angle) {
  const Pose frame = links.pose(group, angle);
  Jaw jaw;
  for (const DescribedSolid& described : links.solids(group)) {
    const Pose pose = composed(frame, described.pose);
    jaw.push_back({described.solid, Eigen::Translation3d(pose.position) * pose.orientation});
  }
  return jaw;
}

SolidDistance Mouth::distanceTo(const Jaw& jaw, const Vec3& point) {
  SolidDistance nearest{std::numeric_limits<double>::infinity(), Vec3::UnitZ()};
  for (const Shape& shape : jaw) {
    const SolidDistance one = shape.solid->distanceTo(shape.pose.inverse(Eigen::Isometry) * point);
    if (one.distance < nearest.distance) nearest = {one.distance, shape.pose.linear() * one.normal};
  }
  return nearest;
}

std::vector<Vec3> Mouth::inFirstJaw() const {
  std::vector<Vec3> inside;
  for (const Shape& shape : jaws_[0])
    overLattice(boxRound(*shape.solid), [&](const Vec3& point) {
      if (shape.solid->distanceTo(point).distance < 0) inside.push_back(shape.pose * point);
    });
  return inside;
}

/// Appends points of the way from where it leaves the first jaw to where it comes upon the second, if it does.
void Mouth::addRoomBefore(const Vec3& inside, const Vec3& direction, std::vector<Vec3>* points) const {
  const double least = MET * reach_;
  double way = 0, left = -1;
  for (int k = 0; k < MOST_STEPS && way < reach_; ++k) {
    const Vec3 at = inside + way * direction;
    const double first = distanceTo(jaws_[0], at).distance, second = distanceTo(jaws_[1], at).distance;
    if (second < least) break;
    if (first < least && left >= 0 && way > left + least) return;
    if (first >= least && left < 0) left = way;
    way += std::max(left < 0 ? -first : std::min(first, second), least);
  }
  if (left < 0 || distanceTo(jaws_[1], inside + way * direction).distance >= least) return;
  for (int k = 0; k < LAYERS; ++k) points->push_back(inside + (left + (k + 0.5) / LAYERS * (way - left)) * direction);
}

/// Which jaw a walk comes upon, or −1: none within reach.
int Mouth::firstMet(const Vec3& from, const Vec3& direction) const {
  double way = 0;
  for (int k = 0; k < MOST_STEPS && way < reach_; ++k) {
    const Vec3 at = from + way * direction;
    const double first = distanceTo(jaws_[0], at).distance, second = distanceTo(jaws_[1], at).distance;
    const double nearest = std::min(first, second);
    if (nearest < MET * reach_) return first <= second ? 0 : 1;
    way += nearest;
  }
  return -1;
}

bool Mouth::isBetween(Vec3 point) const {
  for (const Jaw& jaw : jaws_) {
    const SolidDistance at = distanceTo(jaw, point);
    if (at.distance < -pressed_) return false;
    if (at.distance < 2 * MET * reach_) point += (2 * MET * reach_ - at.distance) * at.normal;
  }
  const Vec3 direction = links_.closing(point).stableNormalized();
  if (direction.isZero(0)) return false;
  const int ahead = firstMet(point, direction);
  return ahead >= 0 && firstMet(point, -direction) == 1 - ahead;
}

}  // namespace incision
