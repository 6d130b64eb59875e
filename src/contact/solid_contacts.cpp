#include "incision/contact/solid_contacts.h"

#include <optional>

namespace incision {
namespace {

/// A share of a shape's thickness. Where the edge is that of a thin box, the other side of its narrow face is just as
/// far from it as the shape gives way.
constexpr double ROUNDING = 1e-6;

/// Length of the mean of the normals of a vertex's sides, below which they have none together: it is 0.58 at the corner
/// of a box, and 0.33 where the two faces of a slit end in the skin.
constexpr double LEAST_SIDE = 0.5;

/// Least share of its weights that a vertex of a slit must have for itself to be pushed aside: with less the material
/// at the slit's end keeps its two faces together, and copies would have to go ten times as far as the vertex.
constexpr double LEAST_UNSHARED = 0.1;

Eigen::Isometry3d toIsometry(const Pose& pose) { return Eigen::Translation3d(pose.position) * pose.orientation; }

/// A solid through the step.
struct MovingShape {
  const Solid* solid;
  Eigen::Isometry3d in_link, from, to;
  double reach;                // of the solid [m]
  double moved = 0;            // a bound on how far any point of it moves [m]
  bool in_slits = false;       // it may stand in a slit
  const Edge* edge = nullptr;  // in the link's frame, near which it gives way
};

MovingShape placeShape(const Obstacle& obstacle, const SolidsInStep& solids, const StepSpan& span) {
  const Eigen::Isometry3d in_link = toIsometry(obstacle.pose);
  MovingShape placed{obstacle.solid.get(), in_link, in_link, in_link, obstacle.solid->reach()};
  if (obstacle.link == GROUND_LINK) return placed;
  const RigidMotion& motion = solids.motions[static_cast<std::size_t>(obstacle.link)];
  placed.from = toIsometry(motion.at(span.from)) * in_link;
  placed.to = toIsometry(motion.at(span.to)) * in_link;
  placed.moved = (placed.to.translation() - placed.from.translation()).norm() +
                 placed.reach * (placed.to.linear() - placed.from.linear()).norm();
  placed.in_slits = solids.in_slits;
  placed.edge = solids.cutting_edge;
  return placed;
}

/// The unit normal of the surface at a vertex, to which each of its sides gives alike; none where they look against
/// each other.
std::optional<Vec3> normalAt(const ContactSurface& surface, const std::vector<Vec3>& x, int vertex) {
  const int first = surface.sample_start[vertex], last = surface.sample_start[vertex + 1];
  Vec3 sum = Vec3::Zero();
  for (int s = first; s < last; ++s) {
    Vec3 area = Vec3::Zero();
    for (int k = surface.samples[s].first; k < surface.samples[s].last; ++k) {
      const auto& [a, b, c] = surface.surface->triangles[surface.around[k]];
      area += (x[b] - x[a]).cross(x[c] - x[a]);
    }
    sum += area.stableNormalized();
  }
  if (!(sum.norm() > LEAST_SIDE * (last - first))) return std::nullopt;
  return sum.normalized();
}

/// From the nearest point, but on the side on which the point was, if it was; also where it has come out on the far side
/// of something thin.
SolidDistance distanceFrom(const Vec3* known_side, const Solid& solid, const Vec3& point) {
  const SolidDistance nearest = solid.distanceTo(point);
  if (!known_side) return nearest;
  const double facing = nearest.normal.dot(*known_side);
  if (facing > 0 || (nearest.distance >= 0 && facing > -LEAST_OPPOSITION)) return nearest;
  return {known_side->dot(point) - solid.reachAlong(*known_side), *known_side};
}

bool givesWay(const MovingShape& shape, const Vec3& foot) {
  if (!shape.edge) return false;
  const Vec3 at = shape.in_link * foot;
  return (at - nearestOn(*shape.edge, at)).norm() <= (1 + ROUNDING) * shape.solid->thickness();
}

/// What keeps a vertex off a shape that may stand in a slit, in the shape's frame, where the vertex is at `point`: the
/// nearest point, unless that is on the far side of its material. The far side is told by the side on which the vertex
/// was, if it was, else by the surface's normal. A slit need not run just in the middle of the blade that cuts it, so
/// that counts also a little beside the shape; but what would have to cross more than the blade is no face of the slit.
/// Nothing does where a vertex has no side to go to, as at the slit's end.
std::optional<SolidDistance> keepOff(const ContactSurface& surface, const std::vector<Vec3>& x, int vertex,
                                     const MovingShape& shape, const Vec3& point, const Vec3* known_side) {
  const SolidDistance nearest = shape.solid->distanceTo(point);
  const double aside = DEEPEST_BEGIN * surface.size[vertex], width = shape.solid->thickness();
  if (nearest.distance > aside) return nearest;
  if (surface.unshared[vertex] < LEAST_UNSHARED) return std::nullopt;
  Vec3 n;
  if (known_side) {
    n = -*known_side;
  } else if (const std::optional<Vec3> now = normalAt(surface, x, vertex)) {
    n = shape.from.linear().transpose() * *now;
  } else {
    return std::nullopt;
  }
  const double facing = -nearest.normal.dot(n);
  if (facing > (known_side ? 0 : LEAST_OPPOSITION)) return nearest;
  const SolidDistance across = shape.solid->distanceAgainst(point, n);
  if (nearest.distance < 0) return known_side || across.distance > -width - aside ? across : nearest;
  const double off = shape.solid->distanceTo(point - across.distance * across.normal).distance;
  return facing < -LEAST_OPPOSITION && off < ROUNDING * width ? across : nearest;
}

/// The candidate of a vertex against a shape, whose nearest point `nearest` tells, the vertex being at `local` in the
/// shape's frame; none where the two cannot meet in the step.
std::optional<Candidate> candidateAt(const ContactSkin& skin, int vertex, const MovingShape& shape, const Vec3& local,
                                     const SolidDistance& nearest) {
  const ContactSurface& surface = skin.surface();
  const Vec3 foot = local - nearest.distance * nearest.normal;
  if (givesWay(shape, foot)) return std::nullopt;
  Candidate candidate;
  candidate.sample = vertex;
  candidate.normal_in_solid = nearest.normal;
  candidate.normal = shape.to.linear() * nearest.normal;
  candidate.gap = candidate.normal.dot(skin.x()[vertex] - shape.from * foot);
  candidate.drift = shape.to * foot - shape.from * foot;
  const double closing = candidate.normal.dot(skin.ahead()[vertex] - candidate.drift);
  const double size = surface.size[vertex];
  if (!(candidate.gap + closing < MARGIN * size)) return std::nullopt;
  candidate.slip.setZero();
  candidate.size = size;
  candidate.stiffness = OBSTACLE_STIFFNESS * surface.young_modulus[vertex] * surface.area[vertex] / size;
  addVertex(surface.surface->vertices[vertex], 1, &candidate.point);
  return candidate;
}

bool mayMeet(const ContactSkin& skin, int vertex, const MovingShape& shape) {
  const double room =
      shape.reach + shape.moved + MARGIN * skin.surface().size[vertex] + skin.ahead()[vertex].norm();
  return (skin.x()[vertex] - shape.from.translation()).squaredNorm() <= room * room && skin.surface().area[vertex] > 0;
}

}  // namespace

void findSolidContacts(const ContactSkin& skin, const StepSpan& span, const SolidsInStep& solids,
                       const std::vector<Touch>& touches, std::vector<Candidate>* candidates) {
  auto touch = touches.begin();
  for (std::size_t o = 0; o < solids.solids.shapes.size(); ++o) {
    const MovingShape shape = placeShape(solids.solids.shapes[o], solids, span);
    for (int i = 0; i < static_cast<int>(skin.x().size()); ++i) {
      if (!mayMeet(skin, i, shape)) continue;
      const Vec3 local = shape.from.inverse(Eigen::Isometry) * skin.x()[i];
      Candidate at;
      at.sample = i;
      at.partner = static_cast<int>(o);
      while (touch != touches.end() && comesBefore(*touch, at)) ++touch;
      const bool touched = touch != touches.end() && !comesBefore(at, *touch);
      const Vec3* known_side = touched ? &touch->normal_in_solid : nullptr;
      const std::optional<SolidDistance> nearest = shape.in_slits
                                                       ? keepOff(skin.surface(), skin.x(), i, shape, local, known_side)
                                                       : distanceFrom(known_side, *shape.solid, local);
      if (!nearest) continue;
      std::optional<Candidate> candidate = candidateAt(skin, i, shape, local, *nearest);
      if (!candidate) continue;
      candidate->partner = at.partner;
      candidates->push_back(*candidate);
    }
  }
}

}  // namespace incision
