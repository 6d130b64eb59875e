#include "incision/rigid/shape.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

namespace incision {
namespace {

template <int N>
using Vec = Eigen::Matrix<double, N, 1>;

/// The unit vector along `v`, also where its square would vanish; `otherwise` where `v` is zero.
template <int N>
Vec<N> directionOf(const Vec<N>& v, const Vec<N>& otherwise) {
  const double scale = v.cwiseAbs().maxCoeff();
  return scale > 0 ? (v / scale).normalized() : otherwise;
}

/// Signed distance and outward normal of the box, or rectangle, that reaches from −half to half.
template <int N>
std::pair<double, Vec<N>> distanceToBox(const Vec<N>& half, const Vec<N>& point) {
  const Vec<N> beyond = point.cwiseAbs() - half;  // of each pair of faces; negative between them
  int nearest = 0;
  const double depth = beyond.maxCoeff(&nearest);
  const Vec<N> normal =
      directionOf<N>(beyond.cwiseMax(0), Vec<N>::Unit(nearest));  // of the mirror image in x, y, z > 0
  const Vec<N> side = point.unaryExpr([](double x) { return std::copysign(1.0, x); });
  return {depth > 0 ? beyond.cwiseMax(0).stableNorm() : depth, side.cwiseProduct(normal)};
}

ShapeDistance distanceToSphere(double radius, const Vec3& point) {
  return {point.stableNorm() - radius, directionOf<3>(point, Vec3::UnitZ())};
}

ShapeDistance distanceToBox(const Vec3& size, const Vec3& point) {
  const auto [distance, normal] = distanceToBox<3>(size / 2, point);
  return {distance, normal};
}

/// A rectangle, in the plane through the axis and the point.
ShapeDistance distanceToCylinder(double radius, double length, const Vec3& point) {
  using Eigen::Vector2d;
  const Vector2d across = point.head<2>();
  const Vector2d radial = directionOf<2>(across, Vector2d::UnitX());
  const auto [distance, normal] =
      distanceToBox<2>(Vector2d(radius, length / 2), Vector2d(across.stableNorm(), point.z()));
  return {distance, {normal[0] * radial[0], normal[0] * radial[1], normal[1]}};
}

/// What of a vector lies along the normals of the shape's faces; a round face turns its normal to the vector.
std::array<Vec3, 3> alongFaces(ShapeKind kind, const Vec3& n) {
  switch (kind) {
    case ShapeKind::BOX:
      return {Vec3(n.x(), 0, 0), Vec3(0, n.y(), 0), Vec3(0, 0, n.z())};
    case ShapeKind::CYLINDER:
      return {Vec3(n.x(), n.y(), 0), Vec3(0, 0, n.z()), Vec3::Zero()};
    case ShapeKind::HALF_SPACE:
      return {Vec3(0, 0, n.z()), Vec3::Zero(), Vec3::Zero()};
    case ShapeKind::SPHERE:
      break;
  }
  return {n, Vec3::Zero(), Vec3::Zero()};
}

}  // namespace

ShapeDistance distanceTo(const Shape& shape, const Vec3& point) {
  switch (shape.kind) {
    case ShapeKind::SPHERE:
      return distanceToSphere(shape.size[0], point);
    case ShapeKind::BOX:
      return distanceToBox(shape.size, point);
    case ShapeKind::CYLINDER:
      return distanceToCylinder(shape.size[0], shape.size[2], point);
    case ShapeKind::HALF_SPACE:
      break;
  }
  return {point.z(), Vec3::UnitZ()};
}

ShapeDistance distanceAgainst(const Shape& shape, const Vec3& point, const Vec3& n) {
  ShapeDistance nearest{-std::numeric_limits<double>::infinity(), -n};
  for (const Vec3& share : alongFaces(shape.kind, n)) {
    if (!(share.norm() > LEAST_OPPOSITION)) continue;
    const Vec3 normal = -share.normalized();
    const double distance = normal.dot(point) - reachAlong(shape, normal);
    if (distance > nearest.distance) nearest = {distance, normal};
  }
  return nearest;
}

double thickness(const Shape& shape) {
  switch (shape.kind) {
    case ShapeKind::SPHERE:
      return 2 * shape.size[0];
    case ShapeKind::BOX:
      return shape.size.minCoeff();
    case ShapeKind::CYLINDER:
      return std::min(2 * shape.size[0], shape.size[2]);
    case ShapeKind::HALF_SPACE:
      break;
  }
  return std::numeric_limits<double>::infinity();
}

double reachAlong(const Shape& shape, const Vec3& n) {
  switch (shape.kind) {
    case ShapeKind::SPHERE:
      return shape.size[0];
    case ShapeKind::BOX:
      return n.cwiseAbs().dot(shape.size) / 2;
    case ShapeKind::CYLINDER:
      return shape.size[0] * std::hypot(n.x(), n.y()) + shape.size[2] / 2 * std::abs(n.z());
    case ShapeKind::HALF_SPACE:
      break;
  }
  return n.z() == 1 ? 0 : std::numeric_limits<double>::infinity();
}

}  // namespace incision
