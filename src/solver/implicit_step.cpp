#include "incision/solver/implicit_step.h"

#include <algorithm>
#include <chrono>
#include <functional>
#include <utility>

#include "incision/base/parallel.h"
#include "incision/solver/direct_solver.h"

namespace incision {
namespace {

double millisecondsSince(std::chrono::steady_clock::time_point start) {
  return std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now() - start).count();
}

/// Steps that the fallback takes before the iteration is tried again: what made it fail, a sliver of a piece or a
/// stiffness beyond float, rarely goes away at once.
constexpr int FALLBACK_STEPS = 20;

/// Solves in a step at most. Contacts that close and part mostly settle after one or two.
constexpr int MAX_SOLVES = 8;

/// A search along a step ends where less than this share of the drive at its start is left, or after so many trials.
constexpr double SEARCH_TOLERANCE = 0.1;
constexpr int MAX_SEARCH = 12;

bool allFinite(const std::vector<Vec3>& values) {
  return std::all_of(values.begin(), values.end(), [](const Vec3& v) { return v.allFinite(); });
}

}  // namespace

ImplicitStep::ImplicitStep(const CutMesh& mesh, const Material& material, Mass mass, Pressure pressure, bool warping,
                           const BoundaryConditions& conditions, const SolverSettings& settings)
    : mesh_(mesh),
      conditions_(conditions),
      settings_(settings),
      assembly_(mesh, material, mass, pressure, warping, settings.threads),
      solver_(makeLinearSolver(settings, warping)),
      held_nodes_(heldNodes(mesh.mesh(), conditions.holds)) {}

void ImplicitStep::topologyChanged(const Motion& motion, const std::vector<int>& touched) {
  assembly_.topologyChanged(motion.x, touched);
  touched_.insert(touched_.end(), touched.begin(), touched.end());
  piece_ = mesh_.copyPieces(&pieces_);
  group_ = piece_;
  held_ = heldCopies(mesh_, conditions_.holds, held_nodes_);
  load_forces_ = loadForces(mesh_, conditions_.loads);
  for (int c = static_cast<int>(dv_.size()); c < mesh_.numCopies(); ++c)
    dv_.push_back(mesh_.copyParent(c) < c ? Vec3(dv_[mesh_.copyParent(c)]) : Vec3::Zero());
  for (std::vector<Vec3>& differences : basis_)
    for (int c = static_cast<int>(differences.size()); c < mesh_.numCopies(); ++c)
      differences.push_back(mesh_.copyParent(c) < c ? Vec3(differences[mesh_.copyParent(c)]) : Vec3::Zero());
  topology_known_ = false;
  fallback_steps_ = 0;
}

void ImplicitStep::reset() {
  assembly_.reset();
  solver_ = makeLinearSolver(settings_, assembly_.warping());
  fallback_.reset();
  touched_.clear();
  basis_ = Basis();
  dv_.clear();
}

bool ImplicitStep::advance(double time, double time_step, Motion* motion, const Couple& couple,
                           const std::vector<Vec3>* turned) {
  const auto start = std::chrono::steady_clock::now();
  assembly_.rotate(turned ? *turned : motion->x);
  if (fallback_steps_ > 0 && --fallback_steps_ == 0) topology_known_ = false;
  prepareMatrix(time_step, *motion);
  times_.assembly = millisecondsSince(start);

  const auto solving = std::chrono::steady_clock::now();
  externalForces(time + time_step);
  for (int c = 0; c < mesh_.numCopies(); ++c)
    if (held_[c] >= 0) dv_[c] = conditions_.holds[held_[c]].velocity - motion->v[c];
  const bool solved = solveCoupled(time_step, *motion, couple);
  times_.solve = millisecondsSince(solving);

  const auto updating = std::chrono::steady_clock::now();
  if (!solved || !allFinite(dv_)) {
    for (std::vector<Vec3>& differences : basis_) differences.assign(differences.size(), Vec3::Zero());
    for (Vec3& dv : dv_) dv.setZero();
    return false;
  }
  remember();
  for (int c = 0; c < mesh_.numCopies(); ++c) {
    motion->v[c] += dv_[c];
    motion->x[c] += time_step * motion->v[c];
  }
  times_.update = millisecondsSince(updating);
  return true;
}

/// Solves, and again as long as that changes the couplings, with the last solution as a guess. What else acts on the
/// body is affine in Δv; so between two solutions the impulses that bring it there are between theirs, whatever
/// couplings there may be at that point.
bool ImplicitStep::solveCoupled(double time_step, const Motion& motion, const Couple& couple) {
  couplings_.clear();
  on_tool_ = Wrench();
  if (couple) updateCouplings(time_step, motion, couple);
  stats_ = SolveStats();
  int iterations = 0;
  for (int k = 0; k < MAX_SOLVES; ++k) {
    const bool joined = joinGroups();
    if (joined) prepare(current(), true, time_step, motion);
    if (joined || !matrix_known_ || was_coupled_ || !couplings_.empty())
      matrix_known_ = current()->couplingsChanged(couplings_, time_step);
    was_coupled_ = !couplings_.empty();
    if (!matrix_known_) return false;
    if (k > 0) {
      again_basis_ = basis_;
      again_basis_[0] = dv_before_ = dv_;
    }
    stats_ = solve(time_step, motion, k > 0 ? again_basis_ : basis_);
    iterations += stats_.iterations;
    stats_.iterations = iterations;
    if (!stats_.converged) return false;
    if (!couple) return true;
    findEnd(motion);
    const Wrench before = std::exchange(on_tool_, toolWrench(couplings_, time_step, motion.x, v_end_));
    if (!updateCouplings(time_step, motion, couple)) return true;
    if (k > 0) on_tool_ = between(before, on_tool_, stepBack(time_step, motion, couple));
  }
  return true;
}

/// Where the couplings at the new Δv drive it back, it has gone too far from the last one: takes the point between at
/// which they drive it nowhere along that line. The forces of contacts descend from a convex potential, so this ends
/// circles in which contacts close and part in turn, and what the last solve leaves is no worse than what it began
/// with. Returns the share of the way to the new Δv.
double ImplicitStep::stepBack(double time_step, const Motion& motion, const Couple& couple) {
  towards_ = dv_;
  for (std::size_t c = 0; c < dv_.size(); ++c) towards_[c] -= dv_before_[c];
  const auto driveAt = [&](double share) {
    for (std::size_t c = 0; c < dv_.size(); ++c) dv_[c] = dv_before_[c] + share * towards_[c];
    updateCouplings(time_step, motion, couple);
    return drive(time_step, motion);
  };
  if (!(drive(time_step, motion) < 0)) return 1;
  const double at_start = driveAt(0);
  double near = 0, far = 1, share = 1;
  for (int k = 0; k < MAX_SEARCH; ++k) {
    share = (near + far) / 2;
    const double here = driveAt(share);
    if (std::abs(here) < SEARCH_TOLERANCE * at_start) break;
    (here > 0 ? near : far) = share;
  }
  return share;
}

/// How the forces at Δv drive it on along the last step.
double ImplicitStep::drive(double time_step, const Motion& motion) {
  residual(time_step, motion, dv_, &drive_);
  double sum = 0;
  for (std::size_t c = 0; c < dv_.size(); ++c) sum += drive_[c].dot(towards_[c]);
  return sum;
}

/// The velocities at the end of the step, for Δv as it is.
void ImplicitStep::findEnd(const Motion& motion) {
  v_end_.resize(motion.v.size());
  for (std::size_t c = 0; c < v_end_.size(); ++c) v_end_[c] = motion.v[c] + dv_[c];
}

bool ImplicitStep::updateCouplings(double time_step, const Motion& motion, const Couple& couple) {
  findEnd(motion);
  return couple(time_step, v_end_, &couplings_);
}

/// Joins the groups of pieces that a coupling holds against each other; returns whether that changed any. Groups only
/// grow until the topology changes: pieces that lie on each other often come and go, and a solver takes time to turn.
bool ImplicitStep::joinGroups() {
  bool joined = false;
  for (const Coupling& coupling : couplings_) {
    int group = -1;
    for (int i = 0; i < coupling.count; ++i) {
      if (held_[coupling.copies[i]] >= 0) continue;
      const int other = group_[coupling.copies[i]];
      if (group >= 0 && other != group) {
        std::replace(group_.begin(), group_.end(), std::max(group, other), std::min(group, other));
        joined = true;
      }
      group = group < 0 ? other : std::min(group, other);
    }
  }
  return joined;
}

/// Takes Δv into the differences: D_0 = Δv, D_k = D_{k−1} − its value a step ago.
void ImplicitStep::remember() {
  parallelFor(mesh_.numCopies(), settings_.threads, [&](int c) {
    Vec3 next = dv_[c];
    for (std::vector<Vec3>& differences : basis_) {
      const Vec3 last = differences[c];
      differences[c] = next;
      next -= last;
    }
  });
}

void ImplicitStep::prepareMatrix(double time_step, const Motion& motion) {
  const bool new_system = !topology_known_ || time_step != matrix_time_step_;
  if (!new_system && matrix_known_ && !assembly_.warping()) return;
  prepare(current(), new_system, time_step, motion);
  if (fallback_steps_ == 0) touched_.clear();
  matrix_known_ = false;
  topology_known_ = true;
  matrix_time_step_ = time_step;
}

void ImplicitStep::prepare(LinearSolver* solver, bool new_system, double time_step, const Motion& motion) {
  if (new_system) {
    const Material& material = assembly_.material();
    std::vector<bool> held(held_.size());
    for (std::size_t c = 0; c < held.size(); ++c) held[c] = held_[c] >= 0;
    solver->systemChanged(
        assembly_, {held, piece_, group_, touched_},
        {1 + time_step * material.mass_damping, time_step * material.stiffness_damping + time_step * time_step});
  }
  solver->matrixChanged(motion.x);
}

SolveStats ImplicitStep::solve(double time_step, const Motion& motion, const Basis& basis) {
  double reach = 0;
  for (const Vec3& x : motion.x) reach = std::max(reach, x.cwiseAbs().maxCoeff());
  rounding_.resize(assembly_.forceRounding().size());
  for (std::size_t c = 0; c < rounding_.size(); ++c) rounding_[c] = time_step * reach * assembly_.forceRounding()[c];
  const auto evaluate = [&](const std::vector<Vec3>& dv, std::vector<Vec3>* at) {
    residual(time_step, motion, dv, at);
  };
  const Residual r = std::cref(evaluate);  // a reference fits into it: no allocation

  if (fallback_steps_ > 0) return fallback_->solve(r, rounding_, basis, &dv_);
  SolveStats stats = solver_->solve(r, rounding_, basis, &dv_);
  if (stats.converged) return stats;
  if (!fallback_) fallback_ = std::make_unique<DirectSolver>();
  fallback_steps_ = FALLBACK_STEPS;
  prepare(fallback_.get(), true, time_step, motion);
  if (!fallback_->couplingsChanged(couplings_, time_step)) return stats;
  const int iterations = stats.iterations;
  stats = fallback_->solve(r, rounding_, basis, &dv_);
  stats.iterations = iterations;
  return stats;
}

/// M g and the tractions, as they stand at the end of the step.
void ImplicitStep::externalForces(double time) {
  external_.resize(mesh_.numCopies());
  for (int c = 0; c < mesh_.numCopies(); ++c) external_[c] = assembly_.masses()[c] * conditions_.gravity;
  for (std::size_t l = 0; l < load_forces_.size(); ++l) {
    const double ramp = conditions_.loads[l].ramp;
    const double share = ramp > 0 ? std::min(1.0, time / ramp) : 1;
    for (int c = 0; c < mesh_.numCopies(); ++c) external_[c] += share * load_forces_[l][c];
  }
}

// The right-hand side less the left at a trial Δv, gathered so that the elements are visited once: as f(y) = f_int + K
// (y − x) is affine in y with slope K,
//   r = Δt f_ext − M (Δv + α Δt (v + Δv)) − Δt f(x + (Δt + β)(v + Δv)).
void ImplicitStep::residual(double time_step, const Motion& motion, const std::vector<Vec3>& dv, std::vector<Vec3>* r) {
  const double alpha = assembly_.material().mass_damping, beta = assembly_.material().stiffness_damping;
  const int copies = mesh_.numCopies();
  const auto inertial = [&](int c) -> Vec3 { return dv[c] + alpha * time_step * (motion.v[c] + dv[c]); };
  y_.resize(copies);
  parallelFor(copies, settings_.threads,
              [&](int c) { y_[c] = motion.x[c] + (time_step + beta) * (motion.v[c] + dv[c]); });
  assembly_.elasticForces(y_, r);
  if (assembly_.consistentMass()) {
    for (int c = 0; c < copies; ++c) y_[c] = inertial(c);
    assembly_.multiplyMass(y_, &inertia_);
  }
  parallelFor(copies, settings_.threads, [&](int c) {
    const Vec3 inertia = assembly_.consistentMass() ? inertia_[c] : Vec3(assembly_.masses()[c] * inertial(c));
    (*r)[c] = time_step * (external_[c] - (*r)[c]) - inertia;
  });
  if (couplings_.empty()) return;
  for (int c = 0; c < copies; ++c) y_[c] = motion.v[c] + dv[c];
  addImpulses(couplings_, time_step, y_, r);
}

}  // namespace incision
