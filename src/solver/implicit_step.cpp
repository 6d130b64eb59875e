#include "incision/solver/implicit_step.h"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <limits>
#include <utility>

#include "incision/base/parallel.h"

namespace incision {
namespace {

double millisecondsSince(std::chrono::steady_clock::time_point start) {
  return std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now() - start).count();
}

/// What turns further than this in a step meets others along a chord that is far from the way on which their impulses
/// drive it: friction could then give energy [rad].
constexpr double FAR_TURN = 0.5;

/// Relative residual that a direct solver leaves at best.
constexpr double ATTAINABLE = 1e-14;

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
      tension_(assembly_),
      solver_(make_solver_(settings, warping)),
      held_nodes_(heldNodes(mesh.mesh(), conditions.clamps)),
      loads_(mesh, conditions.loads) {}

void ImplicitStep::topologyChanged(const Motion& motion, const std::vector<int>& touched) {
  assembly_.topologyChanged(motion.x, touched);
  touched_.insert(touched_.end(), touched.begin(), touched.end());
  piece_ = mesh_.copyPieces(&pieces_);
  memory_.group = piece_;
  held_ = heldCopies(mesh_, conditions_.clamps, held_nodes_);
  loads_.topologyChanged();
  rigid_.topologyChanged(piece_, pieces_, held_, assembly_.warping());
  tension_.topologyChanged(piece_, pieces_, held_);
  norms_known_ = false;
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
  rotated_ = topology_known_ = matrix_known_ = had_springs_ = false;
  group_at_start_.clear();
}

ImplicitStep::Memory ImplicitStep::keep() const {
  Memory kept;
  keepIn(&kept);
  kept.rotations = assembly_.rotations();
  return kept;
}

void ImplicitStep::keepIn(Memory* kept) const {
  kept->basis = memory_.basis;
  kept->group = memory_.group;
  kept->fallback_steps = memory_.fallback_steps;
  kept->solver = memory_.solver;
  kept->solver_time_step = memory_.solver_time_step;
  keepSolver(kept);
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

SystemFactors ImplicitStep::factors() const {
  const Materials& materials = assembly_.materials();
  return {1 + time_step_ * materials.massDamping(), time_step_ * materials.stiffnessDamping() + time_step_ * time_step_,
          &tension_};
}

void ImplicitStep::setThreads(int threads) {
  settings_.threads = threads;
  assembly_.setThreads(threads);
}

const std::vector<Vec3>& ImplicitStep::begin(double time_step, const Motion& motion) {
  time_step_ = time_step;
  rigid_.euler(assembly_, motion, time_step, &base_);
  rotate(base_.x);
  findAhead(motion.x);
  findInertia();
  findTension();
  return ahead_;
}

void ImplicitStep::findTension() {
  tension_.find(settings_.tension, time_step_, base_.x);
  lag_.clear();
}

/// The rotations are at y_.
void ImplicitStep::findTensionAhead() {
  tension_.find(settings_.tension, time_step_, y_);
  lag_.resize(tension_.acts() ? y_.size() : 0);
  for (std::size_t c = 0; c < lag_.size(); ++c) lag_[c] = (y_[c] - base_.x[c]) / time_step_;
}

/// Finds the rotations where the copies go. What its spin drives a piece apart by is left out: a stiff one resists it.
void ImplicitStep::rotateAhead(const Motion& motion) {
  rigid_.euler(assembly_, motion, time_step_, &base_);
  findAhead(motion.x);
  y_.resize(ahead_.size());
  for (std::size_t c = 0; c < ahead_.size(); ++c) y_[c] = motion.x[c] + ahead_[c];
  rotate(y_);
}

/// The first time in a step it leaves the rotations that there were, for a step that fails.
void ImplicitStep::rotate(const std::vector<Vec3>& x) {
  if (rotated_)
    assembly_.rotateOn(x);
  else
    assembly_.rotate(x);
  rotated_ = true;
}

/// What depends on the topology and on Δt alone.
void ImplicitStep::findInertia() {
  if (norms_known_ && norms_time_step_ == time_step_) return;
  norms_known_ = true;
  norms_time_step_ = time_step_;
  norms_.systemChanged(assembly_, factors(), held_, piece_, pieces_);
  inertia_of_.resize(ahead_.size());
  piece_mass_.assign(static_cast<std::size_t>(pieces_), 0);
  for (int c = 0; c < mesh_.numCopies(); ++c) {
    inertia_of_[c] = diagonalOf(assembly_, factors(), c);
    piece_mass_[piece_[c]] += held_[c] >= 0 ? std::numeric_limits<double>::infinity() : assembly_.masses()[c];
  }
}

void ImplicitStep::beginAhead(double time_step, const Motion& motion) {
  time_step_ = time_step;
  rotateAhead(motion);
  rigid_.firstOfSecondOrder(assembly_, motion, time_step, &base_);
  findAhead(motion.x);
  findInertia();
  findTensionAhead();
}

void ImplicitStep::beginSecondOrder(double time_step, const Motion& now, const Motion& before) {
  time_step_ = time_step;
  rotateAhead(now);
  time_step_ = 2 * time_step / 3;
  rigid_.secondOrder(assembly_, now, before, time_step, &base_);
  findAhead(now.x);
  findInertia();
  findTensionAhead();
}

/// Seen from where the copies are at the step's start.
void ImplicitStep::findAhead(const std::vector<Vec3>& start) {
  ahead_.resize(start.size());
  for (std::size_t c = 0; c < ahead_.size(); ++c) ahead_[c] = base_.x[c] - start[c] + time_step_ * base_.u[c];
}

bool ImplicitStep::advance(double time, Motion* motion, Couplers* couplers, StepDemand demand) {
  const auto start = std::chrono::steady_clock::now();
  times_ = StepTimes();
  demand_ = demand;
  fallback_steps_at_start_ = memory_.fallback_steps;
  group_at_start_.clear();
  matrix_ready_ = false;
  keepSolver(&memory_);
  if (memory_.fallback_steps > 0 && --memory_.fallback_steps == 0) topology_known_ = false;
  const bool solved = solve(time, *motion, couplers);
  times_.solve = millisecondsSince(start) - times_.assembly;

  const auto updating = std::chrono::steady_clock::now();
  if (!solved || !allFinite(dv_) || (couplers && !takeChange(*motion, couplers))) {
    giveUp();
    rotated_ = false;
    return false;
  }
  rotated_ = false;
  remember();
  if (wants_clamp_wrenches_) findClampWrenches(couplers != nullptr, *motion);
  if (couplers) {
    findWrenches(*couplers, *motion);
    motion->x.swap(motion_ahead_.x);
    motion->v.swap(motion_ahead_.v);
  } else {
    for (int c = 0; c < mesh_.numCopies(); ++c) {
      motion->v[c] = base_.v[c] + base_.u[c] + dv_[c];
      motion->x[c] = base_.x[c] + time_step_ * (base_.u[c] + dv_[c]);
    }
  }
  times_.update = millisecondsSince(updating);
  return true;
}

/// Finds where the copies go. Returns whether the step is what is demanded.
bool ImplicitStep::takeChange(const Motion& start, Couplers* couplers) {
  balanceMomentum(true, &dv_);
  if (!rigid_.takeChange(assembly_, base_, dv_, newton_.impulsesOnCopies(), start.x, turnLimits())) return false;
  motion_ahead_ = start;
  rigid_.finish(base_, dv_, &motion_ahead_);
  if (demand_ == StepDemand::ANY) return true;
  if (couplers->driveOn(newton_.impulses(), newton_.moved(), start.x, motion_ahead_.x)) return false;
  const SolveStats& stats = newton_.stats();
  return demand_ == StepDemand::SHORT_TURNS ||
         ((stats.settled || stats.cut_short) && couplers->hold(newton_.moved(), motion_ahead_));
}

/// Where a step is taken as well as it goes, a piece turns no farther all the same: what drives it is reckoned along a
/// chord, and would give it energy without bounds.
TurnLimits ImplicitStep::turnLimits() const {
  constexpr double NONE = std::numeric_limits<double>::infinity();
  return demand_ == StepDemand::ANY ? TurnLimits{FAR_TURN, NONE} : TurnLimits{NONE, FAR_TURN};
}

/// The memory is as it was before the step; nothing that is not finite is left in the scratch.
void ImplicitStep::giveUp() {
  topology_known_ = false;
  assembly_.rotateBack();
  memory_.fallback_steps = fallback_steps_at_start_;
  if (!group_at_start_.empty()) memory_.group = group_at_start_;
}

bool ImplicitStep::solve(double time, const Motion& motion, Couplers* couplers) {
  start_x_ = &motion.x;
  given_.clear();
  end_ = time + time_step_;
  externalImpulses();
  dv_.resize(ahead_.size());
  for (int c = 0; c < mesh_.numCopies(); ++c)
    if (held_[c] >= 0) dv_[c] = heldVelocity(c) - base_.v[c] - base_.u[c];
  double reach = 0;
  for (const Vec3& x : base_.x) reach = std::max(reach, x.cwiseAbs().maxCoeff());
  const double tolerance = settings_.method == Method::DIRECT ? ATTAINABLE : settings_.tolerance;
  return newton_.solve({this, couplers, time_step_, tolerance, settings_.threads, settings_.iterations, ahead_,
                        external_, time_step_ * reach, memory_.basis, piece_, held_, memory_.group, rigid_, base_.x},
                       &norms_, &dv_);
}

/// With this a held copy ends where its clamp does.
Vec3 ImplicitStep::heldVelocity(int copy) const {
  const auto clamp = static_cast<std::size_t>(held_[copy]);
  if (clamp_ends_.empty() || !clamp_ends_[clamp]) return conditions_.clamps[clamp].velocity;
  const Pose& end = *clamp_ends_[clamp];
  const Vec3& rest = mesh_.mesh().nodes[mesh_.copyNode(copy)];
  return (placed(rest, end) - base_.x[copy]) / time_step_;
}

/// What the equation leaves at a held copy is what its clamp takes up.
void ImplicitStep::findClampWrenches(bool coupled, const Motion& start) {
  clamp_wrenches_.assign(conditions_.clamps.size(), Wrench());
  for (int c = 0; c < mesh_.numCopies(); ++c) {
    if (held_[c] < 0) continue;
    Vec3 left = newton_.residual()[c];
    if (coupled) left += newton_.impulsesOnCopies()[c];
    Wrench& wrench = clamp_wrenches_[static_cast<std::size_t>(held_[c])];
    wrench.force += left / time_step_;
    wrench.torque += start.x[c].cross(left / time_step_);
  }
}

/// What the springs did to the other ends. Their levers are where their points are when the step starts: by them an
/// impulse changes Σ x × m v from there to the step's end.
void ImplicitStep::findWrenches(const Couplers& couplers, const Motion& start) {
  const std::vector<Spring>& springs = couplers.springs();
  levers_.resize(springs.size());
  for (std::size_t i = 0; i < springs.size(); ++i) levers_[i] = weightedSum(springs[i], start.x);
  couplers.findWrenches(newton_.impulses(), levers_, &felt_);
}

/// The momentum of a free piece changes by the impulses of loads, weight and springs alone, whatever a solve has left
/// of it: what is off is shared by all its copies.
void ImplicitStep::balanceMomentum(bool coupled, std::vector<Vec3>* dv) {
  const double alpha = time_step_ * assembly_.materials().massDamping();
  const std::vector<double>& masses = assembly_.masses();
  off_.assign(static_cast<std::size_t>(pieces_), Vec3::Zero());
  bool any = false;
  for (double mass : piece_mass_) any = any || std::isfinite(mass);
  for (std::size_t c = 0; any && c < dv->size(); ++c) {
    Vec3& off = off_[static_cast<std::size_t>(piece_[c])];
    off += external_[c] - masses[c] * ((*dv)[c] + alpha * (base_.v[c] + base_.u[c] + (*dv)[c]));
    if (coupled) off += newton_.impulsesOnCopies()[c];
    if (!given_.empty()) off -= given_[c];
  }
  for (std::size_t c = 0; any && c < dv->size(); ++c) {
    const auto piece = static_cast<std::size_t>(piece_[c]);
    if (std::isfinite(piece_mass_[piece])) (*dv)[c] += off_[piece] / ((1 + alpha) * piece_mass_[piece]);
  }
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

/// The matrix is made when the first solve of a step asks for it: a body at rest asks for none.
void ImplicitStep::prepareMatrix(bool joined) {
  const auto start = std::chrono::steady_clock::now();
  matrix_ready_ = true;
  const bool new_system = joined || !topology_known_ || time_step_ != matrix_time_step_;
  if (new_system || !matrix_known_ || assembly_.warping()) {
    prepare(current(), new_system, joined);
    if (memory_.fallback_steps == 0) touched_.clear();
    matrix_known_ = false;
    topology_known_ = true;
    matrix_time_step_ = time_step_;
  }
  times_.assembly += millisecondsSince(start);
}

/// A solver that is told of a system anew gets back what the memory has of it, unless groups have just joined.
void ImplicitStep::prepare(LinearSolver* solver, bool new_system, bool joined) {
  if (new_system) {
    std::vector<bool> held(held_.size());
    for (std::size_t c = 0; c < held.size(); ++c) held[c] = held_[c] >= 0;
    solver->systemChanged(assembly_, {held, piece_, memory_.group, touched_}, factors());
    const bool same_solver = (memory_.fallback_steps > 0) == (fallback_steps_at_start_ > 0);
    if (!topology_known_ && !joined && same_solver && time_step_ == memory_.solver_time_step)
      solver->recall(memory_.solver);
  }
  solver->matrixChanged(base_.x);
}

}  // namespace incision
