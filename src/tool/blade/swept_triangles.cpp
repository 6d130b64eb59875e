#include "incision/tool/blade/swept_triangles.h"

#include <algorithm>

namespace incision {
namespace {

/// By so much of its size a triangle's box is larger than the triangle: far more than the rim that isBehind counts in.
constexpr double ROOM = 1e-6;

/// Below this share of its length what of an edge lies across a direction is mostly rounding.
constexpr double MIN_ACROSS = 1e-3;

/// A unit vector across the direction, along the longest edge of a triangle where that can be: an edge sweeps long and
/// narrow triangles, one beside the other, and boxes along them have little in them but the triangle.
Vec3 axisFor(Span<const SweptTriangle> triangles, const Vec3& direction) {
  const Vec3 along = direction.normalized();
  Vec3 longest = Vec3::Zero();
  for (int i = 0; i < 3 && triangles.size() > 0; ++i) {
    const Vec3 edge = (triangles[0][(i + 1) % 3] - triangles[0][i]).tail<3>();
    if (edge.squaredNorm() > longest.squaredNorm()) longest = edge;
  }
  const Vec3 across = rejected(longest, along);
  return across.norm() > MIN_ACROSS * longest.norm() ? Vec3(across.normalized()) : direction.unitOrthogonal();
}

}  // namespace

void SweptTriangles::add(const std::vector<SweptTriangle>& more) {
  const std::size_t added = std::min(more.size(), MOST);
  const Span<const SweptTriangle> old = all();
  const std::size_t kept = std::min(static_cast<std::size_t>(old.size()), MOST - added);
  std::vector<SweptTriangle> triangles;
  triangles.reserve(kept + added);
  triangles.insert(triangles.end(), old.end() - kept, old.end());
  triangles.insert(triangles.end(), more.end() - static_cast<std::ptrdiff_t>(added), more.end());
  triangles_ = std::make_shared<const std::vector<SweptTriangle>>(std::move(triangles));
}

SweptShadow::SweptShadow(Span<const SweptTriangle> triangles, const Vec3& direction,
                         const std::vector<Barycentric>& points)
    : direction_(direction) {
  const Vec3 first = axisFor(triangles, direction);
  axes_.row(0) = first.transpose();
  axes_.row(1) = direction.normalized().cross(first).transpose();
  Eigen::AlignedBox2d reach;
  for (const Barycentric& point : points) reach.extend(seen(point));
  for (const SweptTriangle& triangle : triangles) {
    Eigen::AlignedBox2d box;
    for (const Barycentric& corner : triangle) box.extend(seen(corner));
    const Eigen::Vector2d room = Eigen::Vector2d::Constant(ROOM * box.sizes().maxCoeff());
    box = {box.min() - room, box.max() + room};
    if (box.intersects(reach)) triangles_.push_back({&triangle, box});
  }
}

}  // namespace incision
