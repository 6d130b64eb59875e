#include "incision/contact/obstacle_contacts.h"

#include <optional>

namespace incision {
namespace {

/// Of a shape's thickness. Where the edge is that of a thin box, the other side of its narrow face is just as far from
/// it as the shape gives way.
constexpr double ROUNDING = 1e-6;

/// Length of the mean of the normals of a vertex's sides, below which they have none together: it is 0.58 at the corner
/// of a box, and 0.33 where the two faces of a slit end in the skin.
constexpr double LEAST_SIDE = 0.5;

/// Least share of its weights that a vertex of a slit must have for itself to be pushed aside: with less the material
/// at the slit's end holds its two faces together, and copies would have to go ten times as far as the vertex.
constexpr double LEAST_OWN = 0.1;

Eigen::Isometry3d toIsometry(const Pose& pose) { return Eigen::Translation3d(pose.position) * pose.orientation; }

/// An obstacle through the step.
struct MovingShape {
  const Solid* solid;
  Eigen::Isometry3d in_link, from, to;
  bool is_tool;
  double reach;                // of the solid [m]
  double moved = 0;            // a bound on how far any point of it moves [m]
  const Edge* edge = nullptr;  // in the link's frame, near which it gives way
};

MovingShape placeShape(const Obstacle& obstacle, const Obstacles& obstacles, const LinkMotion& motion) {
  const Eigen::Isometry3d in_link = toIsometry(obstacle.pose);
  MovingShape placed{obstacle.solid.get(),   in_link, in_link, in_link, obstacles.isTool(obstacle),
                     obstacle.solid->reach()};
  if (obstacle.link == GROUND_LINK) return placed;
  placed.from = toIsometry(motion.from[obstacle.link]) * in_link;
  placed.to = toIsometry(motion.to[obstacle.link]) * in_link;
  placed.moved = (placed.to.translation() - placed.from.translation()).norm() +
                 placed.reach * (placed.to.linear() - placed.from.linear()).norm();
  if (placed.is_tool && motion.cuts) placed.edge = &obstacles.tool.edge;
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

/// From the nearest point, but on the side on which the point was, if it was.
SolidDistance distanceFrom(const Vec3* side, const Solid& solid, const Vec3& point) {
  const SolidDistance nearest = solid.distanceTo(point);
  if (!side || nearest.distance >= 0 || nearest.normal.dot(*side) > 0) return nearest;
  return {side->dot(point) - solid.reachAlong(*side), *side};
}

bool givesWay(const MovingShape& shape, const Vec3& foot) {
  if (!shape.edge) return false;
  const Vec3 at = shape.in_link * foot;
  return (at - nearestOn(*shape.edge, at)).norm() <= (1 + ROUNDING) * shape.solid->thickness();
}

/// What holds a vertex off a shape of the tool, in the shape's frame, where the vertex is at `point`: the nearest
/// point, unless that is on the far side of its material. The far side is told by the side on which the vertex was, if
/// it was, else by the surface's normal. A slit need not run just in the middle of the blade that cuts it, so that
/// counts also a little beside the shape; but what would have to cross more than the blade is no face of the slit.
/// Nothing does where a vertex has no side to go to, as at the slit's end.
std::optional<SolidDistance> holdOff(const ContactSurface& surface, const std::vector<Vec3>& x, int vertex,
                                     const MovingShape& shape, const Vec3& point, const Vec3* side) {
  const SolidDistance nearest = shape.solid->distanceTo(point);
  const double aside = DEEPEST_BEGIN * surface.size[vertex], width = shape.solid->thickness();
  if (nearest.distance > aside) return nearest;
  if (surface.own[vertex] < LEAST_OWN) return std::nullopt;
  Vec3 n;
  if (side) {
    n = -*side;
  } else if (const std::optional<Vec3> now = normalAt(surface, x, vertex)) {
    n = shape.from.linear().transpose() * *now;
  } else {
    return std::nullopt;
  }
  const double facing = -nearest.normal.dot(n);
  if (facing > (side ? 0 : LEAST_OPPOSITION)) return nearest;
  const SolidDistance across = shape.solid->distanceAgainst(point, n);
  if (nearest.distance < 0) return side || across.distance > -width - aside ? across : nearest;
  const double off = shape.solid->distanceTo(point - across.distance * across.normal).distance;
  return facing < -LEAST_OPPOSITION && off < ROUNDING * width ? across : nearest;
}

}  // namespace

void findObstacleContacts(const ContactSurface& surface, const std::vector<Vec3>& x, const std::vector<Vec3>& v,
                          double time_step, double stiffness, const Obstacles& obstacles, const LinkMotion& motion,
                          const std::vector<Touch>& touches, std::vector<Candidate>* candidates) {
  auto touch = touches.begin();
  for (std::size_t o = 0; o < obstacles.shapes.size(); ++o) {
    const MovingShape shape = placeShape(obstacles.shapes[o], obstacles, motion);
    if (shape.is_tool && !motion.has_tool) continue;
    for (std::size_t i = 0; i < x.size(); ++i) {
      const double size = surface.size[i], area = surface.area[i];
      const double room = shape.reach + shape.moved + MARGIN * size + time_step * v[i].norm();
      if (!((x[i] - shape.from.translation()).squaredNorm() <= room * room) || !(area > 0)) continue;
      const Vec3 local = shape.from.inverse(Eigen::Isometry) * x[i];
      Candidate candidate;
      candidate.sample = static_cast<int>(i);
      candidate.partner = static_cast<int>(o);
      while (touch != touches.end() && comesBefore(*touch, candidate)) ++touch;
      const bool touched = touch != touches.end() && !comesBefore(candidate, *touch);
      const Vec3* side = touched ? &touch->side : nullptr;
      const std::optional<SolidDistance> nearest = shape.is_tool
                                                       ? holdOff(surface, x, candidate.sample, shape, local, side)
                                                       : distanceFrom(side, *shape.solid, local);
      if (!nearest) continue;
      const Vec3 foot = local - nearest->distance * nearest->normal;
      if (givesWay(shape, foot)) continue;
      candidate.side = nearest->normal;
      candidate.normal = shape.to.linear() * nearest->normal;
      candidate.gap = candidate.normal.dot(x[i] - shape.from * foot);
      candidate.drift = shape.to * foot - shape.from * foot;
      const double closing = candidate.normal.dot(time_step * v[i] - candidate.drift);
      if (!(candidate.gap + closing < MARGIN * size)) continue;
      candidate.slip.setZero();
      candidate.size = size;
      candidate.stiffness = stiffness * area / size;
      candidate.held.tool = shape.is_tool;
      addVertex(surface.surface->vertices[i], 1, &candidate.held);
      candidates->push_back(candidate);
    }
  }
}

}  // namespace incision
