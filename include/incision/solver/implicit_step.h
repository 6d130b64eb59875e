#pragma once

#include <memory>
#include <vector>

#include "incision/fem/boundary.h"
#include "incision/solver/couplers.h"
#include "incision/solver/linear_solver.h"
#include "incision/solver/motion.h"

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
};

/// One linearly implicit step at a time: from (x, v)
///   (M + Δt C + Δt² K) Δv = Δt (f_ext − C v − f_int − Δt K v),  v += Δv,  x += Δt v,  C = α M + β K.
class ImplicitStep {
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
  /// Puts a memory back that was kept since the mesh changed.
  void recall(const Memory& memory);

  /// Before the first step, and after every cut with the nodes round which it changed parts or copies.
  void topologyChanged(const Motion& motion, const std::vector<int>& touched = {});

  /// Forgets everything that came after the construction, as the mesh was replaced. topologyChanged must follow.
  void reset();

  /// Advances from `time` by `time_step` [s], under the couplers where there are any; these must have begun the step.
  /// The rotations are those at the positions `turned` where these are given, else at the step's start. Returns false,
  /// with the motion and the memory as they were, when the system cannot be factorised or a value is not finite.
  bool advance(double time, double time_step, Motion* motion, Couplers* couplers = nullptr,
               const std::vector<Vec3>* turned = nullptr);

  const Assembly& assembly() const { return assembly_; }
  const SolveStats& stats() const { return stats_; }
  const StepTimes& times() const { return times_; }
  /// What the body did to the other end of each coupler in the last step, by just the impulses that changed the body's
  /// momentum.
  const std::vector<Wrench>& felt() const { return felt_; }
  /// The clamp of each copy, or −1: it is free.
  const std::vector<int>& held() const { return held_; }
  /// The piece of each copy, and how many there are.
  const std::vector<int>& pieceOf() const { return piece_; }
  int pieces() const { return pieces_; }

 private:
  void prepareMatrix(double time_step, const Motion& motion);
  void prepare(LinearSolver* solver, bool new_system, double time_step, const Motion& motion);
  void keepSolver(Memory* memory) const;
  void makeFallback();
  void giveUp();
  bool trySolve(double time, double time_step, const Motion& motion, Couplers* couplers);
  bool solveCoupled(double time_step, const Motion& motion, Couplers* couplers);
  bool updateSprings(const Motion& motion, Couplers* couplers);
  void findEnd(const Motion& motion);
  double searchLine(double time_step, const Motion& motion, Couplers* couplers);
  double slopeAlongSearch(double time_step, const Motion& motion);
  bool joinGroups();
  const std::vector<Spring>& springs() const;
  LinearSolver* current() const { return memory_.fallback_steps > 0 ? fallback_.get() : solver_.get(); }
  void remember();
  SolveStats solve(double time_step, const Motion& motion, const Basis& basis);
  void externalForces(double time);
  void residual(double time_step, const Motion& motion, const std::vector<Vec3>& dv, std::vector<Vec3>* r);

  const CutMesh& mesh_;
  BoundaryConditions conditions_;
  SolverSettings settings_;
  MakeLinearSolver make_solver_;
  Assembly assembly_;
  std::unique_ptr<LinearSolver> solver_;
  std::vector<int> piece_;  // of each copy
  int pieces_ = 0;
  Memory memory_;
  std::vector<int> held_nodes_, held_;          // hold of each node and copy, or −1
  std::vector<std::vector<Vec3>> load_forces_;  // of each load, by copy [N]
  bool topology_known_ = false, matrix_known_ = false;
  double matrix_time_step_ = 0;
  std::unique_ptr<LinearSolver> fallback_;  // direct, from the first solve that did not converge on
  std::vector<int> touched_;                // since solver_ last looked
  std::vector<double> rounding_;
  Basis again_basis_;                // of the first guess for another solve in one step
  int fallback_steps_at_start_ = 0;  // of the step, in case it fails
  std::vector<int> group_at_start_;  // likewise; empty: they are as they were
  DisjointSets group_sets_;          // of the groups that springs join
  std::vector<Vec3> dv_, external_, y_, inertia_, v_end_;
  std::vector<Vec3> search_start_, search_direction_, search_residual_;  // of the line search, in terms of Δv
  std::vector<Wrench> felt_, felt_at_start_;                             // at Δv, and where the line search starts
  const std::vector<Spring>* springs_ = nullptr;                         // that act now; null: none
  bool had_springs_ = false;  // the matrix that the solver knows has springs in it
  SolveStats stats_;
  StepTimes times_;
};

template <class Archive>
void serialize(Archive& archive, ImplicitStep::Memory& memory) {
  auto& [basis, group, fallback_steps, solver, solver_time_step, rotations] = memory;
  archive(basis, group, fallback_steps, solver, solver_time_step, rotations);
}

}  // namespace incision
