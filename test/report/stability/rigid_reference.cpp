#include "rigid_reference.h"

#include <Eigen/Eigenvalues>
#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>

namespace incision::report {
namespace {

/// A piece as a rigid body about its centre of mass.
struct Whole {
  bool is_free = true;
  Real mass = 0;
  RealVec centre = RealVec::Zero(), velocity = RealVec::Zero(), spin = RealVec::Zero();
  RealMat inertia = RealMat::Zero(), inverse = RealMat::Zero();
  RealMat turn = RealMat::Identity();                    // Q
  RealVec from = RealVec::Zero(), to = RealVec::Zero();  // its rate at the start and at the end

  Real turned = 0;

  RealVec rate() const { return turn * (inverse * (turn.transpose() * spin)); }
};

RealMat rotation(const RealVec& by) {
  const Real angle = by.norm();
  if (angle == 0) return RealMat::Identity();
  return Eigen::AngleAxis<Real>(angle, by / angle).toRotationMatrix();
}

/// A moment of inertia J that is off by a rounding of the largest one turns the piece on by as large a share of ω Δt as
/// that is of J; the arm is √(J/m).
void invert(Real time_step, Whole* whole) {
  const Eigen::SelfAdjointEigenSolver<RealMat> axes(whole->inertia);
  const Real largest = axes.eigenvalues()[2];
  for (int i = 0; i < 3; ++i) {
    const Real J = axes.eigenvalues()[i];
    const RealVec axis = axes.eigenvectors().col(i);
    if (!(J > 1e-9L * largest)) continue;
    whole->inverse += axis * axis.transpose() / J;
    const Real turn = time_step * std::abs(axis.dot(whole->spin)) / J;
    whole->turned = std::max(whole->turned, largest / J * turn * std::sqrt(J / whole->mass));
  }
}

void turnOn(Real time_step, Whole* whole) {
  const RealVec from = whole->rate();
  const RealMat before = whole->turn;
  whole->turn = rotation(time_step * from) * before;
  for (int k = 0; k < 2; ++k) whole->turn = rotation(time_step / 2 * (from + whole->rate())) * before;
}

std::vector<Whole> wholesOf(const Rig& rig, const Motion& start, const std::vector<Real>& mass) {
  std::vector<Whole> wholes(rig.step.pieces());
  const std::vector<int>& piece = rig.step.pieceOf();
  for (std::size_t c = 0; c < mass.size(); ++c) {
    Whole& whole = wholes[piece[c]];
    whole.is_free = whole.is_free && rig.step.held()[c] < 0 && rig.step.assembly().warping();
    whole.mass += mass[c];
    whole.centre += mass[c] * start.x[c].cast<Real>();
    whole.velocity += mass[c] * start.v[c].cast<Real>();
  }
  for (Whole& whole : wholes) {
    whole.centre /= whole.mass;
    whole.velocity /= whole.mass;
  }
  for (std::size_t c = 0; c < mass.size(); ++c) {
    Whole& whole = wholes[piece[c]];
    const RealVec r = start.x[c].cast<Real>() - whole.centre;
    whole.spin += mass[c] * r.cross(start.v[c].cast<Real>() - whole.velocity);
    whole.inertia += mass[c] * (r.squaredNorm() * RealMat::Identity() - r * r.transpose());
  }
  return wholes;
}

}  // namespace

ReferenceBase rigidReference(const Rig& rig, const Motion& start, const std::vector<Real>& mass) {
  const Real dt = rig.time_step;
  std::vector<Whole> wholes = wholesOf(rig, start, mass);
  for (Whole& whole : wholes) {
    if (!whole.is_free) continue;
    invert(dt, &whole);
    whole.from = whole.rate();
    const Real most = dt * whole.spin.norm() * whole.inverse.norm();
    const int turns = dt * whole.from.norm() > 0.3L ? static_cast<int>(std::min(1e4L, std::ceil(most / 0.05L))) : 1;
    for (int k = 0; k < turns; ++k) turnOn(dt / turns, &whole);
    whole.to = whole.rate();
  }
  ReferenceBase base;
  for (std::size_t c = 0; c < mass.size(); ++c) {
    const Whole& whole = wholes[rig.step.pieceOf()[c]];
    const RealVec x = start.x[c].cast<Real>(), v = start.v[c].cast<Real>(), r = x - whole.centre;
    const RealVec arm = whole.turn * r;
    base.x.push_back(whole.is_free ? RealVec(whole.centre + dt * whole.velocity + arm) : x);
    base.v.push_back(whole.is_free ? RealVec(whole.velocity + whole.to.cross(arm)) : RealVec::Zero());
    base.turned.push_back(whole.is_free ? whole.turned : 0);
    base.u.push_back(whole.is_free ? RealVec(whole.turn * (v - whole.velocity - whole.from.cross(r))) : v);
  }
  return base;
}

}  // namespace incision::report
