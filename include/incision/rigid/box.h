#pragma once

#include "incision/rigid/solid.h"

namespace incision {

/// Centred on the origin, its edges along the axes.
class Box : public Solid {
 public:
  explicit Box(const Vec3& size) : size_(size) {}  ///< edge lengths [m]

  SolidDistance distanceTo(const Vec3& point) const override;
  SolidDistance distanceAgainst(const Vec3& point, const Vec3& n) const override;
  double thickness() const override;
  double reachAlong(const Vec3& n) const override;
  double reach() const override;
  /// Along the longest axis (of equal ones the first), where the other two coordinates are smallest.
  std::optional<Edge> edge() const override;
  void check(const std::string& where) const override;
  Drawing drawing() const override;

 private:
  Vec3 size_;
};

}  // namespace incision
