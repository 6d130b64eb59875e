#pragma once

#include "incision/rigid/solid.h"

namespace incision {

/// All of z ≤ 0.
class HalfSpace : public Solid {
 public:
  SolidDistance distanceTo(const Vec3& point) const override;
  SolidDistance distanceAgainst(const Vec3& point, const Vec3& n) const override;
  double thickness() const override;
  double reachAlong(const Vec3& n) const override;
  double reach() const override;
  void check(const std::string&) const override {}
  Drawing drawing() const override;
};

}  // namespace incision
