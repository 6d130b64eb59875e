#pragma once

#include <gtest/gtest.h>

#include <cmath>
#include <memory>
#include <set>
#include <utility>
#include <vector>

#include "incision/body/deformable_body.h"
#include "incision/solver/step_in_parts.h"

namespace incision::test {

/// Which solves fail, counted from 0 after each call of `fail`.
struct Failures {
  std::set<int> solves;
  int count = 0;
  void fail(const std::set<int>& which) {
    solves = which;
    count = 0;
  }
};

/// A solver that fails on demand, and otherwise is the one that the settings ask for.
class FailingSolver : public LinearSolver {
 public:
  FailingSolver(std::unique_ptr<LinearSolver> solver, Failures* failures)
      : solver_(std::move(solver)), failures_(failures) {}
  void systemChanged(const Assembly& assembly, const SystemChange& change, const SystemFactors& factors) override {
    solver_->systemChanged(assembly, change, factors);
  }
  void matrixChanged(const std::vector<Vec3>& x) override { solver_->matrixChanged(x); }
  bool springsChanged(const std::vector<Spring>& springs, double time_step) override {
    return solver_->springsChanged(springs, time_step);
  }
  void keep(SolverMemory* memory) const override { solver_->keep(memory); }
  void recall(const SolverMemory& memory) override { solver_->recall(memory); }
  int correct(const std::vector<Vec3>& r, const SolveDemand& demand, const Basis* basis, std::vector<Vec3>* d,
              std::vector<Vec3>* left) override {
    const int iterations = solver_->correct(r, demand, basis, d, left);
    if (failures_->solves.count(failures_->count++) == 0) return iterations;
    for (Vec3& value : *d) value.setConstant(std::nan(""));
    return iterations;
  }
  bool isDirect() const override { return solver_->isDirect(); }

 private:
  std::unique_ptr<LinearSolver> solver_;
  Failures* failures_;
};

/// Tries of a step that fails: the whole of it, its first half, quarter and so on.
inline constexpr int TRIES = MAX_HALVINGS + 1;

/// Solves from one to before another.
inline std::set<int> solvesBetween(int first, int last) {
  std::set<int> solves;
  for (int k = first; k < last; ++k) solves.insert(k);
  return solves;
}

/// The solves of a step that fails: in each try one, where a direct one follows.
inline const std::set<int> ALL = solvesBetween(0, 2 * TRIES);

/// Those of a step that fails after its first and shortest part has been tried with two solves that do not.
inline std::set<int> afterAPart() {
  std::set<int> solves = solvesBetween(0, 2 * TRIES - 2);
  solves.merge(solvesBetween(2 * TRIES, 100));
  return solves;
}

/// A body whose solver fails on demand.
struct Fallible {
  explicit Fallible(const Scene& scene, const Descriptions& descriptions = {})
      : body(scene, loadMesh(scene), descriptions, [this](const SolverSettings& settings, bool warping) {
          return std::make_unique<FailingSolver>(makeLinearSolver(settings, warping), &failures);
        }) {}

  /// The next step fails, by these of its solves. No copy that there was has moved.
  void failOnce(const std::set<int>& solves) {
    const std::vector<Vec3> x = body.positions(), v = body.velocities();
    failures.fail(solves);
    EXPECT_THROW(body.step(), StepFailed);
    failures.fail({});
    EXPECT_EQ(std::vector<Vec3>(body.positions().begin(), body.positions().begin() + x.size()), x);
    EXPECT_EQ(std::vector<Vec3>(body.velocities().begin(), body.velocities().begin() + v.size()), v);
  }

  Failures failures;
  DeformableBody body;
};

}  // namespace incision::test
