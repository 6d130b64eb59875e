#pragma once

#include <memory>
#include <vector>

#include "incision/fem/boundary.h"
#include "incision/solver/coupling.h"
#include "incision/solver/linear_solver.h"

namespace incision {

/// Positions and velocities of all copies.
struct Motion {
  std::vector<Vec3> x;  ///< [m]
  std::vector<Vec3> v;  ///< [m/s]
};

/// Forces from outside and what is held.
struct BoundaryConditions {
  Vec3 gravity = Vec3::Zero();  ///< [m/s²]
  std::vector<Hold> holds;
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
  ImplicitStep(const CutMesh& mesh, const Material& material, Mass mass, Pressure pressure, bool warping,
               const BoundaryConditions& conditions, const SolverSettings& settings);

  /// Before the first step, and after every cut with the nodes round which it changed parts or copies.
  void topologyChanged(const Motion& motion, const std::vector<int>& touched = {});

  /// Forgets everything that came after the construction, as the mesh was replaced.
  void reset();

  /// Advances from `time` by `time_step` [s], under couplings where `couple` is given. The rotations are those at the
  /// positions `turned` where these are given, else at the step's start. Returns false, with the motion as it was, when
  /// the system cannot be factorised or a value is not finite.
  bool advance(double time, double time_step, Motion* motion, const Couple& couple = {},
               const std::vector<Vec3>* turned = nullptr);

  const Assembly& assembly() const { return assembly_; }
  const SolveStats& stats() const { return stats_; }
  const StepTimes& times() const { return times_; }
  /// What the couplings with the tool did to it in the last step, as toolWrench says, by just the impulses that changed
  /// the body's momentum.
  const Wrench& onTool() const { return on_tool_; }
  /// The hold of each copy, or −1.
  const std::vector<int>& held() const { return held_; }
  /// The piece of each copy, and how many there are.
  const std::vector<int>& pieceOf() const { return piece_; }
  int pieces() const { return pieces_; }

 private:
  void prepareMatrix(double time_step, const Motion& motion);
  void prepare(LinearSolver* solver, bool new_system, double time_step, const Motion& motion);
  bool solveCoupled(double time_step, const Motion& motion, const Couple& couple);
  bool updateCouplings(double time_step, const Motion& motion, const Couple& couple);
  void findEnd(const Motion& motion);
  double stepBack(double time_step, const Motion& motion, const Couple& couple);
  double drive(double time_step, const Motion& motion);
  bool joinGroups();
  LinearSolver* current() { return fallback_steps_ > 0 ? fallback_.get() : solver_.get(); }
  void remember();
  SolveStats solve(double time_step, const Motion& motion, const Basis& basis);
  void externalForces(double time);
  void residual(double time_step, const Motion& motion, const std::vector<Vec3>& dv, std::vector<Vec3>* r);

  const CutMesh& mesh_;
  BoundaryConditions conditions_;
  SolverSettings settings_;
  Assembly assembly_;
  std::unique_ptr<LinearSolver> solver_;
  std::vector<int> piece_;  // of each copy
  int pieces_ = 0;
  std::vector<int> group_;  // of each copy: pieces that couplings have held together since the topology changed
  std::vector<int> held_nodes_, held_;          // hold of each node and copy, or −1
  std::vector<std::vector<Vec3>> load_forces_;  // of each load, by copy [N]
  bool topology_known_ = false, matrix_known_ = false;
  double matrix_time_step_ = 0;
  std::unique_ptr<LinearSolver> fallback_;  // direct, from the first solve that did not converge on
  int fallback_steps_ = 0;                  // how many more steps it takes
  std::vector<int> touched_;                // since solver_ last looked
  std::vector<double> rounding_;
  Basis basis_;        // of the first guess: the last Δv and its backward differences
  Basis again_basis_;  // the same for another solve in the same step
  std::vector<Vec3> dv_, external_, y_, inertia_, v_end_;
  std::vector<Vec3> dv_before_, towards_, drive_;  // where a step towards other couplings begins, itself, and residual
  std::vector<Coupling> couplings_;
  Wrench on_tool_;
  bool was_coupled_ = false;  // the matrix that the solver knows holds couplings
  SolveStats stats_;
  StepTimes times_;
};

}  // namespace incision
