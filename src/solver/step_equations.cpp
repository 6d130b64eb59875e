// What Newton's method asks of a step: its equations, and their solution with springs.
#include <algorithm>

#include "incision/base/parallel.h"
#include "incision/solver/implicit_step.h"

namespace incision {
namespace {

/// Steps that the fallback takes before the iteration is tried again: what made it fail, a sliver of a piece or a
/// stiffness beyond float, rarely goes away at once.
constexpr int FALLBACK_STEPS = 20;

}  // namespace

bool ImplicitStep::setSprings(const std::vector<Spring>& springs) {
  const bool joined = joinGroups(springs);
  if (!matrix_ready_) {
    prepareMatrix(joined);
  } else if (joined) {
    prepare(current(), true, true);
  }
  const bool any = std::any_of(springs.begin(), springs.end(), [](const Spring& spring) { return spring.isStiff(); });
  if (joined || !matrix_known_ || had_springs_ || any) matrix_known_ = current()->springsChanged(springs, time_step_);
  had_springs_ = any;
  return matrix_known_;
}

/// Joins the groups of pieces that a spring lies between; returns whether that changed any. Groups only grow until the
/// topology changes: pieces that lie on each other often come and go, and a solver takes time to turn.
bool ImplicitStep::joinGroups(const std::vector<Spring>& springs) {
  if (springs.empty()) return false;
  group_sets_.reset(pieces_);
  bool joined = false;
  for (const Spring& spring : springs) {
    if (!spring.isStiff()) continue;
    int last = -1;  // the group of the free copy before; −1: there was none
    for (int i = 0; i < spring.count; ++i) {
      if (held_[spring.copies[i]] >= 0) continue;
      const int group = memory_.group[spring.copies[i]];
      if (last >= 0 && group_sets_.join(last, group)) joined = true;
      last = group;
    }
  }
  if (!joined) return false;
  if (group_at_start_.empty()) group_at_start_ = memory_.group;
  for (int& group : memory_.group) group = group_sets_.lowest(group);
  return true;
}

int ImplicitStep::correct(const std::vector<Vec3>& r, const SolveDemand& demand, const Basis* basis,
                          std::vector<Vec3>* d, std::vector<Vec3>* left) {
  return current()->correct(r, demand, basis, d, left);
}

bool ImplicitStep::rebase(const std::vector<Vec3>& impulses) {
  if (!rigid_.kick(assembly_, *start_x_, impulses, &base_, &given_, turnLimits())) return false;
  findAhead(*start_x_);
  rotate(base_.x);
  lag_.clear();
  if (loads_.anyPresses()) externalImpulses();
  return true;
}

bool ImplicitStep::isDirect() const { return memory_.fallback_steps > 0 || settings_.method == Method::DIRECT; }

bool ImplicitStep::fallBack(const std::vector<Spring>& springs) {
  if (isDirect()) return false;
  makeFallback();
  memory_.fallback_steps = FALLBACK_STEPS;
  prepare(fallback_.get(), true, true);
  matrix_known_ = fallback_->springsChanged(springs, time_step_);
  return matrix_known_;
}

/// Δt times M g and the loads, as they stand at the end of the step on a body that is at x̂.
void ImplicitStep::externalImpulses() {
  external_.resize(mesh_.numCopies());
  for (int c = 0; c < mesh_.numCopies(); ++c) external_[c] = assembly_.masses()[c] * conditions_.gravity;
  loads_.addTo(end_, base_.x, &external_);
  for (Vec3& impulse : external_) impulse *= time_step_;
}

// The right-hand side less the left at a trial Δv, gathered so that the elements are visited once: as f(y) = f_int + K
// (y − x̂) is affine in y with slope K,
//   r = Δt f_ext − M (Δv + α Δt (v̂ + u + Δv)) − Δt f(x̂ + (Δt + β)(u + Δv)) − Δt² K_σ (u + Δv).
void ImplicitStep::residual(const std::vector<Vec3>& dv, std::vector<Vec3>* r) {
  const double alpha = assembly_.materials().massDamping(), beta = assembly_.materials().stiffnessDamping();
  const int copies = mesh_.numCopies();
  const auto inertial = [&](int c) -> Vec3 { return dv[c] + alpha * time_step_ * (base_.v[c] + base_.u[c] + dv[c]); };
  y_.resize(copies);
  parallelFor(copies, settings_.threads,
              [&](int c) { y_[c] = base_.x[c] + (time_step_ + beta) * (base_.u[c] + dv[c]); });
  assembly_.elasticForces(y_, r);
  if (assembly_.consistentMass()) {
    for (int c = 0; c < copies; ++c) y_[c] = inertial(c);
    assembly_.multiplyMass(y_, &inertia_);
  }
  parallelFor(copies, settings_.threads, [&](int c) {
    const Vec3 inertia = assembly_.consistentMass() ? inertia_[c] : Vec3(assembly_.masses()[c] * inertial(c));
    (*r)[c] = external_[c] - time_step_ * (*r)[c] - inertia;
    if (!given_.empty()) (*r)[c] -= given_[c];
  });
  if (!tension_.acts()) return;
  parallelFor(copies, settings_.threads, [&](int c) {
    y_[c] = base_.u[c] + dv[c];
    if (!lag_.empty()) y_[c] -= lag_[c];
  });
  tension_.multiply(y_, &pulls_);
  parallelFor(copies, settings_.threads, [&](int c) { (*r)[c] -= pulls_[c]; });
}

}  // namespace incision
