#pragma once

#include <Eigen/Core>
#include <cmath>

#include "support/rig.h"

namespace incision::report {

using Vec2 = Eigen::Vector2d;

/// A crack with a round front: a disc, or a cap of a sphere that bulges against its axis.
class RoundCrack {
 public:
  /// The front is the circle of a radius [m] round an axis; at the front the crack rises by `angle` towards it.
  RoundCrack(double radius, double angle, const Vec3& axis, const Vec3& middle);

  double radius() const { return radius_; }
  bool isFlat() const { return angle_ == 0; }
  RoundCrack scaled(double by) const { return RoundCrack(by * radius_, angle_, axis_, middle_); }

  /// The crack made `longer` by so much [m], in a body at rest at `x`.
  CrackField field(const CutMesh& mesh, const std::vector<Vec3>& x, double longer) const;

  /// The place at angle ω of the front, `r` [m] behind it along the crack.
  Vec3 place(double omega, double r) const;
  /// Axes there: ahead, away from the crack's middle; across, towards its positive side; along the front.
  Mat3 axes(double omega, double r) const;
  /// Seen along the axis.
  Vec2 plan(const Vec3& X) const { return {first_.dot(X - middle_), second_.dot(X - middle_)}; }

 private:
  double distance(const Vec3& X) const;
  double behindFront(const Vec3& X) const;
  double polarAngle(double r) const { return angle_ - r / sphere_; }
  Vec3 outward(double omega) const { return std::cos(omega) * first_ + std::sin(omega) * second_; }

  double radius_, angle_;
  Vec3 axis_, first_, second_, middle_;  // of the front's circle
  double sphere_ = 0;                    // radius [m]
  Vec3 centre_ = Vec3::Zero();           // of the sphere
};

}  // namespace incision::report
