#pragma once

#include <Eigen/Geometry>
#include <vector>

#include "incision/cut/cut_mesh.h"

namespace incision {

/// A point is in an element up to this beyond its faces, in its own coordinates: rounding.
inline constexpr double OUTSIDE = 1e-9;

/// Map between the body and an element's coordinates as one part sees them.
class PartFrame {
 public:
  PartFrame(const Part& part, const std::vector<Vec3>& x);
  bool invertible() const { return invertible_; }
  Barycentric toElement(const Vec3& point) const;
  Vec3 toBody(const Barycentric& b) const { return origin_ + edges_ * b.tail<3>(); }

 private:
  Vec3 origin_;
  Mat3 edges_, inverse_;
  bool invertible_ = false;
};

/// Box round a part's copies, the whole element.
Eigen::AlignedBox3d boxOf(const Part& part, const std::vector<Vec3>& x);

/// Whether a point of the element lies in the part.
bool encloses(const Polytope& polytope, const Barycentric& point);

}  // namespace incision
