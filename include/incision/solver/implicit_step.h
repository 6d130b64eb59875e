#pragma once

#include <memory>
#include <optional>
#include <vector>

#include "incision/base/memory_limits.h"
#include "incision/fem/boundary.h"
#include "incision/fem/loads.h"
#include "incision/fem/tension.h"
#include "incision/solver/couplers.h"
#include "incision/solver/linear_solver.h"
#include "incision/solver/newton.h"
#include "incision/solver/rigid_pieces.h"

namespace incision {

/// Forces from outside and clamps.
struct BoundaryConditions {
  Vec3 gravity = Vec3::Zero();  ///< [m/s²]
  std::vector<Clamp> clamps;
  std::vector<Load> loads;
};

/// Wall time [ms] of the phases of a step.
struct StepTimes {
  double assembly = 0, solve = 0, update = 0;

  StepTimes& operator+=(const StepTimes& other) {
    assembly += other.assembly;
    solve += other.solve;
    update += other.update;
    return *this;
  }
};

/// How a step may be taken.
enum class StepDemand {
  ANY,          ///< as well as it goes
  SHORT_TURNS,  ///< only where no piece that couplers act on turns far
  SOUND,        ///< only where it settles, too
};

/// One linearly implicit step at a time, from the base x̂, v̂, u that the rigid motion of free pieces leaves:
///   (M + Δt C + Δt² (K + K_σ)) Δv = Δt (f_ext − α M (v̂ + u) − β K u − f_int(x̂) − Δt (K + K_σ) u),  C = α M + β K,
///   v ← v̂ + u + Δv,  x ← x̂ + Δt (u + Δv).
/// In a step of second order, whose rotations are found ahead, K_σ resists what leads away from there.
class ImplicitStep : private StepEquations {
 public:
  /// `make_solver` makes the linear solvers; left out, they are those that the settings ask for.
  ImplicitStep(const CutMesh& mesh, const Materials& materials, Mass mass, Pressure pressure, bool warping,
               const BoundaryConditions& conditions, const SolverSettings& settings,
               MakeLinearSolver make_solver = makeLinearSolver);

  /// What outlasts a step, but for the motion.
  struct Memory {
    Basis basis;             ///< of the first guess: the last Δv and its backward differences, by copy
    std::vector<int> group;  ///< of each copy: pieces between which springs have been since the mesh changed
    int fallback_steps = 0;  ///< how many more steps the fallback takes
    /// Of the linear solver, where it has been told of the system of a step of this length [s]; 0: of none.
    SolverMemory solver;
    double solver_time_step = 0;
    std::vector<Mat3> rotations;  ///< of each part; only in what is kept
  };
  Memory keep() const;
  /// Copies all of it but the rotations into the room that `kept` has.
  void keepIn(Memory* kept) const;
  /// Puts a memory back that was kept since the mesh changed.
  void recall(const Memory& memory);

  /// From here on the rotations can be taken back, as Assembly::takeMarked says.
  void markRotations() noexcept { assembly_.markRotations(); }
  void takeMarked(std::vector<Mat3>* rotations) noexcept { assembly_.takeMarked(rotations); }

  /// Before the first step, and after every cut with the nodes round which it changed parts or copies.
  void topologyChanged(const Motion& motion, const std::vector<int>& touched = {});

  /// Forgets everything that came after the construction, as the mesh was replaced or a step was broken off.
  /// topologyChanged must follow.
  void reset();

  /// Takes these instead of those that it was made with. Between steps.
  void setGravity(const Vec3& gravity) { conditions_.gravity = gravity; }
  void setTolerance(double tolerance) { settings_.tolerance = tolerance; }
  void setThreads(int threads);

  /// A step starts: finds its base. Returns how far each copy goes in the step if nothing new acts on it [m].
  const std::vector<Vec3>& begin(double time_step, const Motion& motion);
  /// Of this step, as StepStart says.
  const std::vector<double>& inertia() const { return inertia_of_; }
  const std::vector<double>& pieceMass() const { return piece_mass_; }
  /// A step of implicit Euler starts from which those of second order may go on, with the rotations where it goes if
  /// nothing new acts rather than where its base is.
  void beginAhead(double time_step, const Motion& motion);
  /// A step of second order starts, as RigidPieces says: one of 2/3 `time_step`; with the rotations ahead too.
  void beginSecondOrder(double time_step, const Motion& now, const Motion& before);

  /// For each clamp, where its nodes are at the end of the next step: at D X. Without D they move with its velocity.
  void setClampEnds(const std::vector<std::optional<Pose>>& ends) { clamp_ends_ = ends; }

  /// Takes the rotations at these positions [m] instead, in the step that has begun.
  void rotate(const std::vector<Vec3>& x);

  /// Takes the step that has begun, at `time` [s], under the couplers where there are any; these must have begun it
  /// too. Returns false, with the motion and the memory as they were, when the system cannot be factorised, a value is
  /// not finite or the step is not what is demanded.
  bool advance(double time, Motion* motion, Couplers* couplers = nullptr, StepDemand demand = StepDemand::ANY);

  const Assembly& assembly() const { return assembly_; }
  /// As it was found for the last step.
  const Tension& tension() const { return tension_; }
  const SolveStats& stats() const { return newton_.stats(); }
  const StepTimes& times() const { return times_; }
  /// How far the point of each spring has gone in the last step [m].
  const std::vector<Vec3>& moved() const { return newton_.moved(); }
  /// What the body did to the other end of each coupler in the last step, by just the impulses that changed the body's
  /// momentum.
  const std::vector<Wrench>& felt() const { return felt_; }
  /// What each spring did to the body in the last step [N s], and the lever by which it did so [m].
  const std::vector<Vec3>& impulses() const { return newton_.impulses(); }
  const std::vector<Vec3>& levers() const { return levers_; }
  /// What the body did to each clamp in the last step: the force at its held copies is what the step's equation leaves
  /// there, springs included, and the torque is about the origin of the body's frame, by levers as those of springs.
  /// Found only where it is wanted, as at first it is not.
  void wantClampWrenches(bool wanted) { wants_clamp_wrenches_ = wanted; }
  const std::vector<Wrench>& clampWrenches() const { return clamp_wrenches_; }
  const Loads& loads() const { return loads_; }
  /// The clamp of each copy, or −1: it is free.
  const std::vector<int>& held() const { return held_; }
  /// The piece of each copy, and how many there are.
  const std::vector<int>& pieceOf() const { return piece_; }
  int pieces() const { return pieces_; }

 private:
  // The equations of the step.
  void residual(const std::vector<Vec3>& dv, std::vector<Vec3>* r) override;
  bool setSprings(const std::vector<Spring>& springs) override;
  int correct(const std::vector<Vec3>& r, const SolveDemand& demand, const Basis* basis, std::vector<Vec3>* d,
              std::vector<Vec3>* left) override;
  bool isDirect() const override;
  bool rebase(const std::vector<Vec3>& impulses) override;
  void balance(std::vector<Vec3>* dv) override { balanceMomentum(false, dv); }
  bool fallBack(const std::vector<Spring>& springs) override;

  void findAhead(const std::vector<Vec3>& start);
  void findTension();
  void findTensionAhead();
  void findInertia();
  void rotateAhead(const Motion& motion);
  void externalImpulses();
  Vec3 heldVelocity(int copy) const;
  void findClampWrenches(bool coupled, const Motion& start);
  void prepareMatrix(bool joined);
  void prepare(LinearSolver* solver, bool new_system, bool joined);
  bool solve(double time, const Motion& motion, Couplers* couplers);
  bool joinGroups(const std::vector<Spring>& springs);
  void findWrenches(const Couplers& couplers, const Motion& start);
  void keepSolver(Memory* memory) const;
  void makeFallback();
  void balanceMomentum(bool coupled, std::vector<Vec3>* dv);
  bool takeChange(const Motion& start, Couplers* couplers);
  TurnLimits turnLimits() const;
  void remember();
  void giveUp();
  LinearSolver* current() const { return memory_.fallback_steps > 0 ? fallback_.get() : solver_.get(); }
  SystemFactors factors() const;

  const CutMesh& mesh_;
  BoundaryConditions conditions_;
  SolverSettings settings_;
  MakeLinearSolver make_solver_;
  Assembly assembly_;
  Tension tension_;
  std::unique_ptr<LinearSolver> solver_;
  std::unique_ptr<LinearSolver> fallback_;  // direct, from the first solve that did not converge on
  std::vector<int> piece_;                  // of each copy
  int pieces_ = 0;
  std::vector<double> piece_mass_;  // of each piece, infinite where it is held [kg]
  std::vector<double> inertia_of_;  // of each copy: a third of trace(A_cc) [kg]
  Memory memory_;
  RigidPieces rigid_;
  PieceNorms norms_;
  Newton newton_;
  std::vector<int> held_nodes_, held_;  // hold of each node and copy, or −1
  Loads loads_;
  std::vector<std::optional<Pose>> clamp_ends_;  // of each clamp in the next step; empty: none has an end
  std::vector<int> touched_;                     // since solver_ last looked
  bool topology_known_ = false, matrix_known_ = false, norms_known_ = false;
  double matrix_time_step_ = 0, norms_time_step_ = 0;
  bool had_springs_ = false;         // the matrix that the solver knows has springs in it
  DisjointSets group_sets_;          // of the groups that springs join
  int fallback_steps_at_start_ = 0;  // of the step, in case it fails
  std::vector<int> group_at_start_;  // likewise; empty: they are as they were
  // Of this step:
  double time_step_ = 0;
  double end_ = 0;  // time when it ends [s]
  StepDemand demand_ = StepDemand::ANY;
  StepBase base_;
  Motion motion_ahead_;  // where couplers have the step end
  bool matrix_ready_ = false, rotated_ = false;
  const std::vector<Vec3>* start_x_ = nullptr;
  std::vector<Vec3> off_;    // momentum of each piece [N s]
  std::vector<Vec3> given_;  // momentum that the base has got from couplers, by copy [N s]; empty: none
  std::vector<Vec3> ahead_, dv_, external_, y_, inertia_, pulls_, levers_;
  std::vector<Vec3> lag_;  // how fast x̂ would get to where the rotations are, by copy [m/s]; empty: it is there
  std::vector<Wrench> felt_, clamp_wrenches_;
  bool wants_clamp_wrenches_ = false;
  StepTimes times_;
};

template <class Archive>
void serialize(Archive& archive, ImplicitStep::Memory& memory) {
  auto& [basis, group, fallback_steps, solver, solver_time_step, rotations] = memory;
  archive(basis, group, fallback_steps, solver, solver_time_step, rotations);
}

void check(const ImplicitStep::Memory& memory, const MemoryLimits& limits);

}  // namespace incision
