#pragma once

#include "incision/rigid/solid.h"

namespace incision {

/// Centred on the origin, its axis along z.
class Cylinder : public Solid {
 public:
  Cylinder(double radius, double length) : radius_(radius), length_(length) {}  ///< [m]

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
