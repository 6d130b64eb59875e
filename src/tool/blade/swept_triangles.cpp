#include "incision/tool/blade/swept_triangles.h"

#include <algorithm>

namespace incision {
namespace {

/// By so much of its size a triangle's box is larger than the triangle: far more than the rim that isBehind counts in.
constexpr double ROOM = 1e-6;

}  // namespace

void SweptTriangles::add(const std::vector<SweptTriangle>& more) {
  const std::size_t added = std::min(more.size(), MOST);
  const auto old = static_cast<std::size_t>(end() - begin()), kept = std::min(old, MOST - added);
  std::vector<SweptTriangle> all;
  all.reserve(kept + added);
  all.insert(all.end(), end() - kept, end());
  all.insert(all.end(), more.end() - static_cast<std::ptrdiff_t>(added), more.end());
  triangles_ = std::make_shared<const std::vector<SweptTriangle>>(std::move(all));
}

SweptShadow::SweptShadow(const SweptTriangles& triangles, const Vec3& direction,
                         const std::vector<Barycentric>& polygon)
    : direction_(direction) {
  axes_.row(0) = direction.unitOrthogonal().transpose();
  axes_.row(1) = direction.normalized().cross(Vec3(axes_.row(0).transpose())).transpose();
  Eigen::AlignedBox2d reach;
  for (const Barycentric& corner : polygon) reach.extend(seen(corner));
  for (const SweptTriangle& triangle : triangles) {
    Eigen::AlignedBox2d box;
    for (const Barycentric& corner : triangle) box.extend(seen(corner));
    const Eigen::Vector2d room = Eigen::Vector2d::Constant(ROOM * box.sizes().maxCoeff());
    box = {box.min() - room, box.max() + room};
    if (box.intersects(reach)) triangles_.push_back({&triangle, box});
  }
}

bool SweptShadow::covers(const Barycentric& point) const {
  const Eigen::Vector2d at = seen(point);
  return std::any_of(triangles_.begin(), triangles_.end(), [&](const Seen& seen) {
    return seen.box.contains(at) && isBehind(*seen.triangle, point, direction_);
  });
}

Eigen::Vector2d SweptShadow::seen(const Barycentric& point) const { return axes_ * point.tail<3>(); }

}  // namespace incision
