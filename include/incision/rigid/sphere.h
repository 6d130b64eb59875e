#pragma once

#include "incision/rigid/solid.h"

namespace incision {

/// Centred on the origin.
class Sphere : public Solid {
 public:
  explicit Sphere(double radius) : radius_(radius) {}  ///< [m]

  SolidDistance distanceTo(const Vec3& point) const override;
  SolidDistance distanceAgainst(const Vec3& point, const Vec3& n) const override;
  double thickness() const override;
  double reachAlong(const Vec3& n) const override;
  double reach() const override;
  void check(const std::string& where) const override;
  Drawing drawing() const override;

 private:
  double radius_;
};

}  // namespace incision
