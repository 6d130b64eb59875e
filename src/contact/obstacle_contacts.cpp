#include "incision/contact/obstacle_contacts.h"

#include <limits>

namespace incision {
namespace {

Eigen::Isometry3d toIsometry(const Pose& pose) { return Eigen::Translation3d(pose.position) * pose.orientation; }

/// Radius of a ball round the shape's origin that holds it [m].
double reachOf(const Shape& shape) {
  switch (shape.kind) {
    case ShapeKind::SPHERE:
      return shape.size[0];
    case ShapeKind::BOX:
      return shape.size.norm() / 2;
    case ShapeKind::CYLINDER:
      return std::hypot(shape.size[0], shape.size[2] / 2);
    case ShapeKind::HALF_SPACE:
      break;
  }
  return std::numeric_limits<double>::infinity();
}

/// An obstacle through the step.
struct MovingShape {
  Shape shape;
  Eigen::Isometry3d from, to;
};

MovingShape placeShape(const Obstacle& obstacle, const LinkMotion& motion) {
  const Eigen::Isometry3d in_link = toIsometry(obstacle.pose);
  if (obstacle.link == GROUND_LINK) return {obstacle.shape, in_link, in_link};
  return {obstacle.shape, toIsometry(motion.from[obstacle.link]) * in_link,
          toIsometry(motion.to[obstacle.link]) * in_link};
}

/// From the nearest point, but on the side on which the point was, if it was.
ShapeDistance distanceFrom(const Vec3* side, const Shape& shape, const Vec3& point) {
  const ShapeDistance nearest = distanceTo(shape, point);
  if (!side || nearest.distance >= 0 || nearest.normal.dot(*side) > 0) return nearest;
  return {side->dot(point) - reachAlong(shape, *side), *side};
}

}  // namespace

void findObstacleContacts(const ContactSurface& surface, const std::vector<Vec3>& x, const std::vector<Vec3>& v,
                          double time_step, double stiffness, const Obstacles& obstacles, const LinkMotion& motion,
                          const std::vector<Touch>& touches, std::vector<Candidate>* candidates) {
  auto touch = touches.begin();
  for (std::size_t o = 0; o < obstacles.shapes.size(); ++o) {
    const MovingShape shape = placeShape(obstacles.shapes[o], motion);
    const double reach = reachOf(shape.shape);
    // A bound on how far any point of the obstacle moves.
    const double moved = (shape.to.translation() - shape.from.translation()).norm() +
                         (std::isfinite(reach) ? reach * (shape.to.linear() - shape.from.linear()).norm() : 0);
    for (std::size_t i = 0; i < x.size(); ++i) {
      const double size = surface.size[i], area = surface.area[i];
      const double room = reach + moved + MARGIN * size + time_step * v[i].norm();
      if (!((x[i] - shape.from.translation()).squaredNorm() <= room * room) || !(area > 0)) continue;
      const Vec3 local = shape.from.inverse(Eigen::Isometry) * x[i];
      Candidate candidate;
      candidate.sample = static_cast<int>(i);
      candidate.partner = static_cast<int>(o);
      while (touch != touches.end() && comesBefore(*touch, candidate)) ++touch;
      const bool touched = touch != touches.end() && !comesBefore(candidate, *touch);
      const ShapeDistance nearest = distanceFrom(touched ? &touch->side : nullptr, shape.shape, local);
      const Vec3 foot = local - nearest.distance * nearest.normal;
      candidate.side = nearest.normal;
      candidate.normal = shape.to.linear() * nearest.normal;
      candidate.gap = candidate.normal.dot(x[i] - shape.from * foot);
      candidate.drift = shape.to * foot - shape.from * foot;
      const double closing = candidate.normal.dot(time_step * v[i] - candidate.drift);
      if (!(candidate.gap + closing < MARGIN * size)) continue;
      candidate.slip.setZero();
      candidate.size = size;
      candidate.stiffness = stiffness * area / size;
      addVertex(surface.surface->vertices[i], 1, &candidate.held);
      candidates->push_back(candidate);
    }
  }
}

}  // namespace incision
