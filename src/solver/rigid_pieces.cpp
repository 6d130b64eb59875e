#include "incision/solver/rigid_pieces.h"

#include <Eigen/Eigenvalues>
#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>

namespace incision {
namespace {

/// Below this share of what turns a piece too far none is given to it beforehand.
constexpr double LEAST_SHARE = 1e-3;

/// Moments of inertia below this share of the largest are those of a line or of a point, which cannot spin about it.
constexpr double LEAST_INERTIA = 1e-9;

/// What turns by more than this in a step takes short turns, of so much at most, and so many of them [rad].
constexpr double FAST_TURN = 0.3, SHORT_TURN = 0.05, MAX_TURNS = 10000;

/// Corrections of the mean rate over a step by the rate at its end. Each gains an order of the angle.
constexpr int CORRECTIONS = 2;

/// J⁺ for a symmetric positive semidefinite J.
Mat3 pseudoInverse(const Mat3& J) {
  const Eigen::SelfAdjointEigenSolver<Mat3> eigen(J);
  const Vec3& values = eigen.eigenvalues();
  Vec3 inverse = Vec3::Zero();
  for (int i = 0; i < 3; ++i)
    if (values[i] > LEAST_INERTIA * values[2]) inverse[i] = 1 / values[i];
  return eigen.eigenvectors() * inverse.asDiagonal() * eigen.eigenvectors().transpose();
}

/// exp([a]×).
Mat3 rotationBy(const Vec3& a) {
  const double angle = a.norm();
  if (!(angle > 0)) return Mat3::Identity();
  return Eigen::AngleAxisd(angle, a / angle).toRotationMatrix();
}

}  // namespace

void RigidPieces::topologyChanged(const std::vector<int>& piece, int pieces, const std::vector<int>& held,
                                  bool warping) {
  piece_ = piece;
  free_.assign(static_cast<std::size_t>(pieces), warping);
  for (std::size_t c = 0; c < held.size(); ++c)
    if (held[c] >= 0) free_[static_cast<std::size_t>(piece[c])] = false;
  any_free_ = false;
  for (char is_free : free_) any_free_ = any_free_ || is_free;
}

/// L and J are those of the masses of the equation: of the lumped ones, or of the consistent matrix M, where L = Σ r ×
/// (M v) and J = Σ (r · q) 1 − q rᵀ with q = M r.
void RigidPieces::measure(const Assembly& assembly, const Motion& motion) {
  const std::vector<double>& masses = assembly.masses();
  bodies_.assign(free_.size(), {0, Vec3::Zero(), Vec3::Zero(), Vec3::Zero(), Mat3::Zero(), false});
  const std::size_t copies = motion.x.size();
  for (std::size_t c = 0; c < copies; ++c) {
    if (!isFree(c)) continue;
    Body& body = bodies_[static_cast<std::size_t>(piece_[c])];
    body.mass += masses[c];
    body.centre += masses[c] * motion.x[c];
    body.velocity += masses[c] * motion.v[c];
  }
  for (Body& body : bodies_)
    if (body.mass > 0) {
      body.centre /= body.mass;
      body.velocity /= body.mass;
    }
  const bool consistent = assembly.consistentMass();
  if (consistent) {
    assembly.multiplyMass(motion.x, &mass_x_);
    assembly.multiplyMass(motion.v, &mass_v_);
  }
  for (std::size_t c = 0; c < copies; ++c) {
    if (!isFree(c)) continue;
    Body& body = bodies_[static_cast<std::size_t>(piece_[c])];
    const Vec3 r = motion.x[c] - body.centre;
    const Vec3 p = (consistent ? mass_v_[c] : Vec3(masses[c] * motion.v[c])) - masses[c] * body.velocity;
    const Vec3 q = consistent ? Vec3(mass_x_[c] - masses[c] * body.centre) : Vec3(masses[c] * r);
    body.spin += r.cross(p);
    body.inertia += r.dot(q) * Mat3::Identity() - q * r.transpose();
  }
}

/// Twice the mean rate is that at the start and that at the end; there the body has turned by Q and L is as it was.
/// What turns far in a step takes as many short ones: the energy of a spin is that of the angle between L and the body.
RigidPieces::Turn RigidPieces::turnOf(const Body& body, double time_step) {
  const Mat3 J = body.symmetricInertia(), inverse = pseudoInverse(J);
  const Vec3 rate = inverse * body.spin;
  Turn turn{inverse, Mat3::Identity(), rate, rate, Vec3::Zero()};
  const auto turned = [&](const Mat3& A, const Vec3& b) -> Vec3 {
    return turn.rotation * (A * (turn.rotation.transpose() * b));
  };
  const double most = std::abs(time_step) * body.spin.norm() * inverse.norm();
  const bool is_fast = std::abs(time_step) * rate.norm() > FAST_TURN;
  const int turns = is_fast ? static_cast<int>(std::min(MAX_TURNS, std::ceil(most / SHORT_TURN))) : 1;
  for (int n = 0; n < turns; ++n) {
    const Mat3 from = turn.rotation;
    const Vec3 at_start = turned(inverse, body.spin);
    turn.rotation = rotationBy(time_step / turns * at_start) * from;
    for (int k = 0; k < CORRECTIONS; ++k)
      turn.rotation = rotationBy(time_step / turns / 2 * (at_start + turned(inverse, body.spin))) * from;
  }
  turn.ends = turned(inverse, body.spin);
  turn.change = -turned(inverse, turn.ends.cross(turned(J, turn.ends)));
  return turn;
}

/// How far a body turns at the rate that it starts with [rad]: what turnOf takes short turns for.
double RigidPieces::angleOf(const Body& body, double time_step) {
  return time_step * (pseudoInverse(body.symmetricInertia()) * body.spin).norm();
}

void RigidPieces::findTurns(double time_step, std::vector<Turn>* turns) const {
  turns->clear();
  for (const Body& body : bodies_) turns->push_back(turnOf(body, time_step));
}

void RigidPieces::euler(const Assembly& assembly, const Motion& motion, double time_step, StepBase* base) {
  base->x = motion.x;
  base->u = motion.v;
  base->v.assign(motion.x.size(), Vec3::Zero());
  time_step_ = time_step;
  if (!any_free_) return;
  measure(assembly, motion);
  findTurns(time_step, &turns_);
  for (std::size_t c = 0; c < motion.x.size(); ++c) {
    if (!isFree(c)) continue;
    const Body& body = bodies_[static_cast<std::size_t>(piece_[c])];
    const Turn& turn = turns_[static_cast<std::size_t>(piece_[c])];
    moveAlong(c, motion.x[c], base);
    base->u[c] = turn.rotation * (motion.v[c] - body.velocity - turn.rate.cross(motion.x[c] - body.centre));
  }
}

/// Finds x̂ and v̂ of a copy that is at `x` when the step starts. Returns its arm Q r at the step's end.
Vec3 RigidPieces::moveAlong(std::size_t copy, const Vec3& x, StepBase* base) const {
  const Body& body = bodies_[static_cast<std::size_t>(piece_[copy])];
  const Turn& turn = turns_[static_cast<std::size_t>(piece_[copy])];
  const Vec3 Qr = turn.rotation * (x - body.centre);
  base->x[copy] = body.centre + time_step_ * body.velocity + Qr;
  base->v[copy] = body.velocity + turn.ends.cross(Qr);
  return Qr;
}

bool RigidPieces::kick(const Assembly& assembly, const std::vector<Vec3>& x, const std::vector<Vec3>& impulses,
                       StepBase* base, std::vector<Vec3>* given, const TurnLimits& limits) {
  kicks_.assign(free_.size(), Kick());
  given->assign(x.size(), Vec3::Zero());
  for (std::size_t c = 0; c < x.size(); ++c) {
    if (!isFree(c) || impulses[c].isZero(0)) continue;
    Kick& kick = kicks_[static_cast<std::size_t>(piece_[c])];
    kick.is_coupled = true;
    kick.momentum += impulses[c];
    kick.spin += (x[c] - bodies_[static_cast<std::size_t>(piece_[c])].centre).cross(impulses[c]);
  }
  std::vector<Turn>& without = kicked_turns_;
  without = turns_;
  for (std::size_t piece = 0; piece < kicks_.size(); ++piece) {
    Kick& kick = kicks_[piece];
    if (!kick.is_coupled) continue;
    Body& body = bodies_[piece];
    body.is_kicked = true;
    const Vec3 spin = body.spin;
    for (double share = 1;; share = share > LEAST_SHARE ? share / 2 : 0) {
      body.spin = spin + share * kick.spin;
      const double angle = angleOf(body, time_step_);
      if (angle > limits.refused) return false;
      if (angle > limits.most && share > 0) continue;
      turns_[piece] = turnOf(body, time_step_);
      kick.momentum *= share;
      kick.spin *= share;
      break;
    }
    kick.velocity = kick.momentum / body.mass;
    body.velocity += kick.velocity;
    kick.rate = turns_[piece].rateOf(kick.spin);
  }
  for (std::size_t c = 0; c < x.size(); ++c) {
    const auto piece = static_cast<std::size_t>(piece_[c]);
    const Kick& kick = kicks_[piece];
    if (!kick.is_coupled) continue;
    const Vec3 Qr = moveAlong(c, x[c], base);
    base->u[c] = turns_[piece].rotation * (without[piece].rotation.transpose() * base->u[c]);
    (*given)[c] = kick.velocity + kick.rate.cross(Qr);
  }
  if (assembly.consistentMass()) {
    mass_x_ = *given;
    assembly.multiplyMass(mass_x_, given);
  } else {
    for (std::size_t c = 0; c < x.size(); ++c) (*given)[c] *= assembly.masses()[c];
  }
  return true;
}

bool RigidPieces::takeChange(const Assembly& assembly, const StepBase& base, const std::vector<Vec3>& dv,
                             const std::vector<Vec3>& impulses, const std::vector<Vec3>& x, const TurnLimits& limits) {
  findKicks(assembly, base, dv, impulses, x);
  for (std::size_t piece = 0; piece < kicks_.size(); ++piece) {
    Kick& kick = kicks_[piece];
    if (!kick.is_coupled) continue;
    Body& body = kicked_[piece];
    body = bodies_[piece];
    kick.velocity = kick.momentum / body.mass;
    kick.rate = turns_[piece].rateOf(kick.spin);
    body.velocity += kick.velocity;
    body.spin += kick.spin + kick.at_start - kick.at_end;
    const double angle = angleOf(body, time_step_);
    if (angle > limits.refused) return false;
    if (!(angle <= limits.most)) body.spin *= limits.most / angle;
    kicked_turns_[piece] = turnOf(body, time_step_);
  }
  return true;
}

void RigidPieces::finish(const StepBase& base, const std::vector<Vec3>& dv, Motion* motion) const {
  const double h = time_step_;
  for (std::size_t c = 0; c < dv.size(); ++c) {
    const auto piece = static_cast<std::size_t>(piece_[c]);
    const Kick& kick = kicks_[piece];
    if (!kick.is_coupled) {
      motion->v[c] = base.v[c] + base.u[c] + dv[c];
      motion->x[c] = base.x[c] + h * (base.u[c] + dv[c]);
      continue;
    }
    const Body& body = kicked_[piece];
    const Turn& turn = kicked_turns_[piece];
    const Vec3 Qr = turn.rotation * (motion->x[c] - body.centre);
    const Vec3 arm = base.x[c] - centreOf(static_cast<int>(piece));
    const Vec3 beside = base.u[c] + dv[c] - kick.velocity - kick.rate.cross(arm);
    motion->x[c] = body.centre + h * body.velocity + Qr + h * beside;
    motion->v[c] = body.velocity + turn.ends.cross(Qr) + beside;
  }
}

/// Of each free piece on which couplers have acted, or were thought to when the base was made.
void RigidPieces::findKicks(const Assembly& assembly, const StepBase& base, const std::vector<Vec3>& dv,
                            const std::vector<Vec3>& impulses, const std::vector<Vec3>& x) {
  kicks_.assign(free_.size(), Kick());
  if (!any_free_) return;
  for (std::size_t piece = 0; piece < kicks_.size(); ++piece) kicks_[piece].is_coupled = bodies_[piece].is_kicked;
  for (std::size_t c = 0; c < dv.size(); ++c)
    if (isFree(c) && !impulses[c].isZero(0)) kicks_[static_cast<std::size_t>(piece_[c])].is_coupled = true;
  kicked_.resize(free_.size());
  kicked_turns_.resize(free_.size());
  if (assembly.consistentMass()) assembly.multiplyMass(dv, &mass_v_);
  for (std::size_t c = 0; c < dv.size(); ++c) {
    Kick& kick = kicks_[static_cast<std::size_t>(piece_[c])];
    if (!kick.is_coupled) continue;
    const Vec3 arm = base.x[c] - centreOf(piece_[c]);
    const Vec3 momentum = assembly.consistentMass() ? mass_v_[c] : Vec3(assembly.masses()[c] * dv[c]);
    kick.momentum += momentum;
    kick.spin += arm.cross(momentum);
    kick.at_start += (x[c] - bodies_[static_cast<std::size_t>(piece_[c])].centre).cross(impulses[c]);
    kick.at_end += arm.cross(impulses[c]);
  }
}

void RigidPieces::firstOfSecondOrder(const Assembly& assembly, const Motion& motion, double time_step, StepBase* base) {
  euler(assembly, motion, time_step, base);
  for (std::size_t c = 0; c < motion.x.size(); ++c) {
    if (!isFree(c)) continue;
    const Turn& turn = turns_[static_cast<std::size_t>(piece_[c])];
    const Vec3 w = base->u[c], arm_ahead = base->x[c] - centreOf(piece_[c]) + time_step * w;
    base->v[c] += turn.ends.cross(time_step * w);
    base->u[c] -= time_step * turn.accelerationAt(arm_ahead, w);
  }
}

/// The frame goes with the piece's rigid motion of now, backwards and forwards; in it the second order formula holds
/// for places and for velocities w beside the frame, which the frame's own acceleration and Coriolis' drive:
///   m dw/dt = f − m (dω/dt × r + ω × (ω × r) + 2 ω × w).
void RigidPieces::secondOrder(const Assembly& assembly, const Motion& now, const Motion& before, double time_step,
                              StepBase* base) {
  const std::size_t copies = now.x.size();
  base->x.resize(copies);
  base->u.resize(copies);
  base->v.assign(copies, Vec3::Zero());
  if (any_free_) {
    measure(assembly, now);
    findTurns(time_step, &turns_);
    findTurns(-time_step, &turns_back_);
  }
  for (std::size_t c = 0; c < copies; ++c) {
    if (!isFree(c)) {
      base->x[c] = now.x[c] + (now.x[c] - before.x[c]) / 3;
      base->u[c] = now.v[c] + (now.v[c] - before.v[c]) / 3;
      continue;
    }
    const auto piece = static_cast<std::size_t>(piece_[c]);
    const Body& body = bodies_[piece];
    const Turn &turn = turns_[piece], &back = turns_back_[piece];
    const Mat3& Q = turn.rotation;
    const Vec3 r = now.x[c] - body.centre, r_before = before.x[c] - body.centre + time_step * body.velocity;
    const Vec3 w = now.v[c] - body.velocity - turn.rate.cross(r);
    const Vec3 w_before = back.rotation.transpose() * (before.v[c] - body.velocity - back.ends.cross(r_before));
    const Vec3 arm = Q * (r + (r - back.rotation.transpose() * r_before) / 3);
    base->x[c] = body.centre + time_step * body.velocity + arm;
    const Vec3 w_ahead = Q * (2 * w - w_before), arm_ahead = arm + 2 * time_step / 3 * w_ahead;
    base->v[c] = body.velocity + turn.ends.cross(arm_ahead);
    base->u[c] = Q * (w + (w - w_before) / 3) - 2 * time_step / 3 * turn.accelerationAt(arm_ahead, w_ahead);
  }
}

}  // namespace incision
