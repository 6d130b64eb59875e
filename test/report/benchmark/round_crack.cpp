#include "report/benchmark/round_crack.h"

#include <Eigen/Geometry>
#include <cmath>

#include "incision/cut/point.h"

namespace incision::report {

RoundCrack::RoundCrack(double radius, double angle, const Vec3& axis, const Vec3& middle)
    : radius_(radius), angle_(angle), axis_(axis.normalized()), middle_(middle) {
  // The first axis is as near to z as it may be, turned so that what pulls along z shears the positive side along it.
  first_ = Vec3::UnitZ() - axis_.z() * axis_;
  if (first_.norm() < 1e-9) first_ = Vec3::UnitX();
  first_.normalize();
  second_ = axis_.cross(first_);
  if (isFlat()) return;
  sphere_ = radius_ / std::sin(angle_);
  centre_ = middle_ + sphere_ * std::cos(angle_) * axis_;
}

double RoundCrack::distance(const Vec3& X) const {
  return isFlat() ? axis_.dot(X - middle_) : sphere_ - (X - centre_).norm();
}

double RoundCrack::behindFront(const Vec3& X) const {
  if (isFlat()) return radius_ - plan(X).norm();
  const Vec3 from = (X - centre_).normalized();
  return sphere_ * (angle_ - std::atan2(from.cross(axis_).norm(), -from.dot(axis_)));
}

CrackField RoundCrack::field(const CutMesh& mesh, const std::vector<Vec3>& x, double longer) const {
  CrackField field;
  for (int c = 0; c < mesh.numCopies(); ++c) {
    const double phi = distance(x[c]);
    field.phi.push_back(std::abs(phi) < SNAP * mesh.shortestEdge(mesh.copyNode(c)) ? 0 : phi);
  }
  field.contains = [this, &mesh, &x, longer](int part, const std::vector<Barycentric>& polygon) {
    return behindFront(at(mesh.parts()[part], polygonCentroid(polygon), x)) > -longer;
  };
  return field;
}

Vec3 RoundCrack::place(double omega, double r) const {
  if (isFlat()) return middle_ + (radius_ - r) * outward(omega);
  const double theta = polarAngle(r);
  return centre_ + sphere_ * (std::sin(theta) * outward(omega) - std::cos(theta) * axis_);
}

Mat3 RoundCrack::axes(double omega, double r) const {
  const double theta = isFlat() ? 0 : polarAngle(r);
  Mat3 axes;
  axes.col(0) = std::cos(theta) * outward(omega) + std::sin(theta) * axis_;
  axes.col(1) = std::cos(theta) * axis_ - std::sin(theta) * outward(omega);
  axes.col(2) = axes.col(0).cross(axes.col(1));
  return axes;
}

}  // namespace incision::report
