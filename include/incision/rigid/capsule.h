#pragma once

#include "incision/rigid/solid.h"

namespace incision {

/// Centred on the origin: a cylinder along z whose ends are half spheres.
class Capsule : public Solid {
 public:
  /// [m]; `length` is that of the cylinder, between the centres of the half spheres.
  Capsule(double radius, double length) : radius_(radius), length_(length) {}

  SolidDistance distanceTo(const Vec3& point) const override;
  SolidDistance distanceAgainst(const Vec3& point, const Vec3& n) const override;
  double thickness() const override;
  double reachAlong(const Vec3& n) const override;
  double reach() const override;
  void check(const std::string& where) const override;
  Drawing drawing() const override;

 private:
  double radius_, length_;
};

}  // namespace incision
