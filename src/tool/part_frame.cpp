#include "incision/tool/part_frame.h"

#include <Eigen/LU>
#include <algorithm>

#include "incision/cut/section.h"

namespace incision {

PartFrame::PartFrame(const Part& part, const std::vector<Vec3>& x) : origin_(x[part.copies[0]]) {
  for (int k = 0; k < 3; ++k) edges_.col(k) = x[part.copies[k + 1]] - origin_;
  edges_.computeInverseWithCheck(inverse_, invertible_, 0.0);
}

Barycentric PartFrame::toElement(const Vec3& point) const {
  Barycentric b;
  b.tail<3>() = inverse_ * (point - origin_);
  b[0] = 1 - b.tail<3>().sum();
  return b;
}

Eigen::AlignedBox3d boxOf(const Part& part, const std::vector<Vec3>& x) {
  Eigen::AlignedBox3d box(x[part.copies[0]]);
  for (int I = 1; I < 4; ++I) box.extend(x[part.copies[I]]);
  return box;
}

bool encloses(const Polytope& polytope, const Barycentric& point) {
  return std::all_of(polytope.facets.begin(), polytope.facets.end(), [&](const Facet& facet) {
    const auto in_affine = [](const Barycentric& b) -> Vec3 { return b.tail<3>(); };
    const Vec3 out = vectorArea(polytope, facet, in_affine);
    return out.dot((point - polytope.corners[facet.corners[0]]).tail<3>()) <= OUTSIDE;
  });
}

}  // namespace incision
