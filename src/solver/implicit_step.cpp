#include "incision/solver/implicit_step.h"

#include <algorithm>
#include <chrono>
#include <functional>
#include <utility>

#include "incision/base/parallel.h"

namespace incision {
namespace {

double millisecondsSince(std::chrono::steady_clock::time_point start) {
  return std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now() - start).count();
}

/// Steps that the fallback takes before the iteration is tried again: what made it fail, a sliver of a piece or a
/// stiffness beyond float, rarely goes away at once.
constexpr int FALLBACK_STEPS = 20;

bool allFinite(const std::vector<Vec3>& values) {
  return std::all_of(values.begin(), values.end(), [](const Vec3& v) { return v.allFinite(); });
}

}  // namespace

ImplicitStep::ImplicitStep(const CutMesh& mesh, const Materials& materials, Mass mass, Pressure pressure, bool warping,
                           const BoundaryConditions& conditions, const SolverSettings& settings,
                           MakeLinearSolver make_solver)
    : mesh_(mesh),
      conditions_(conditions),
      settings_(settings),
      make_solver_(std::move(make_solver)),
      assembly_(mesh, materials, mass, pressure, warping, settings.threads),
      solver_(make_solver_(settings, warping)),
      held_nodes_(heldNodes(mesh.mesh(), conditions.clamps)) {}

void ImplicitStep::topologyChanged(const Motion& motion, const std::vector<int>& touched) {
  assembly_.topologyChanged(motion.x, touched);
  touched_.insert(touched_.end(), touched.begin(), touched.end());
  piece_ = mesh_.copyPieces(&pieces_);
  memory_.group = piece_;
  held_ = heldCopies(mesh_, conditions_.clamps, held_nodes_);
  load_forces_ = loadForces(mesh_, conditions_.loads);
  dv_.resize(mesh_.numCopies(), Vec3::Zero());
  for (std::vector<Vec3>& differences : memory_.basis)
    for (int c = static_cast<int>(differences.size()); c < mesh_.numCopies(); ++c)
      differences.push_back(mesh_.copyParent(c) < c ? Vec3(differences[mesh_.copyParent(c)]) : Vec3::Zero());
  topology_known_ = false;
  memory_.solver = {};
  memory_.solver_time_step = 0;
  memory_.fallback_steps = 0;
}

void ImplicitStep::reset() {
  assembly_.reset();
  solver_ = make_solver_(settings_, assembly_.warping());
  fallback_.reset();
  touched_.clear();
  memory_ = Memory();
  dv_.clear();
}

ImplicitStep::Memory ImplicitStep::keep() const {
  Memory kept = memory_;
  keepSolver(&kept);
  kept.rotations = assembly_.rotations();
  return kept;
}

/// What the solver would have to be told for its part; as long as it has not been told of the system, that is still in
/// the memory.
void ImplicitStep::keepSolver(Memory* memory) const {
  if (!topology_known_) return;
  memory->solver_time_step = matrix_time_step_;
  current()->keep(&memory->solver);
}

void ImplicitStep::recall(const Memory& memory) {
  topology_known_ = false;
  memory_ = memory;
  assembly_.recallRotations(memory_.rotations);
  memory_.rotations = std::vector<Mat3>();
  if (memory_.fallback_steps > 0) makeFallback();
}

void ImplicitStep::makeFallback() {
  if (fallback_) return;
  SolverSettings direct = settings_;
  direct.method = Method::DIRECT;
  fallback_ = make_solver_(direct, assembly_.warping());
}

bool ImplicitStep::advance(double time, double time_step, Motion* motion, Couplers* couplers,
                           const std::vector<Vec3>* turned) {
  const auto start = std::chrono::steady_clock::now();
  fallback_steps_at_start_ = memory_.fallback_steps;
  group_at_start_.clear();
  keepSolver(&memory_);
  assembly_.rotate(turned ? *turned : motion->x);
  if (memory_.fallback_steps > 0 && --memory_.fallback_steps == 0) topology_known_ = false;
  prepareMatrix(time_step, *motion);
  times_.assembly = millisecondsSince(start);

  const auto solving = std::chrono::steady_clock::now();
  const bool solved = trySolve(time, time_step, *motion, couplers);
  times_.solve = millisecondsSince(solving);

  const auto updating = std::chrono::steady_clock::now();
  if (!solved || !allFinite(dv_)) {
    giveUp();
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

/// The memory is as it was before the step; nothing that is not finite is left in the scratch.
void ImplicitStep::giveUp() {
  topology_known_ = false;
  assembly_.rotateBack();
  memory_.fallback_steps = fallback_steps_at_start_;
  if (!group_at_start_.empty()) memory_.group = group_at_start_;
  for (Vec3& dv : dv_) dv.setZero();
}

bool ImplicitStep::trySolve(double time, double time_step, const Motion& motion, Couplers* couplers) {
  externalForces(time + time_step);
  for (int c = 0; c < mesh_.numCopies(); ++c) {
    if (held_[c] >= 0)
      dv_[c] = conditions_.clamps[held_[c]].velocity - motion.v[c];
    else if (couplers)
      dv_[c] = memory_.basis[0][c];  // a guess, for which they find their springs
  }
  return solveCoupled(time_step, motion, couplers);
}

/// Takes Δv into the differences: D_0 = Δv, D_k = D_{k−1} − its value a step ago.
void ImplicitStep::remember() {
  parallelFor(mesh_.numCopies(), settings_.threads, [&](int c) {
    Vec3 next = dv_[c];
    for (std::vector<Vec3>& differences : memory_.basis) {
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
  if (memory_.fallback_steps == 0) touched_.clear();
  matrix_known_ = false;
  topology_known_ = true;
  matrix_time_step_ = time_step;
}

void ImplicitStep::prepare(LinearSolver* solver, bool new_system, double time_step, const Motion& motion) {
  if (new_system) {
    const Materials& materials = assembly_.materials();
    std::vector<bool> held(held_.size());
    for (std::size_t c = 0; c < held.size(); ++c) held[c] = held_[c] >= 0;
    solver->systemChanged(
        assembly_, {held, piece_, memory_.group, touched_},
        {1 + time_step * materials.massDamping(), time_step * materials.stiffnessDamping() + time_step * time_step});
    const bool same_solver = (memory_.fallback_steps > 0) == (fallback_steps_at_start_ > 0);
    if (!topology_known_ && same_solver && time_step == memory_.solver_time_step) solver->recall(memory_.solver);
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

  if (memory_.fallback_steps > 0) return fallback_->solve(r, rounding_, basis, &dv_);
  SolveStats stats = solver_->solve(r, rounding_, basis, &dv_);
  if (stats.converged) return stats;
  makeFallback();
  memory_.fallback_steps = FALLBACK_STEPS;
  prepare(fallback_.get(), true, time_step, motion);
  if (!fallback_->springsChanged(springs(), time_step)) return stats;
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
  const double alpha = assembly_.materials().massDamping(), beta = assembly_.materials().stiffnessDamping();
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
  if (springs().empty()) return;
  for (int c = 0; c < copies; ++c) y_[c] = motion.v[c] + dv[c];
  addImpulses(springs(), time_step, y_, r);
}

}  // namespace incision
