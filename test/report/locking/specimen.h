#pragma once

#include "report/locking/problem.h"
#include "support/rig.h"

namespace incision::report {

/// The body of a problem, at rest under its load.
class Specimen : public Rig {
 public:
  Specimen(const Problem& problem, TetMesh rest, double poisson_ratio, Pressure pressure,
           const std::vector<PlaneCut>& cuts = {});

  /// What the problem asks [m or N].
  double answer() const;
  /// Blocks in the matrix.
  int blocks() const;

 private:
  Problem problem_;
};

/// What a step takes of the same body in motion: warped, under ten times the load, in steps of 0.01 s.
struct StepCost {
  double milliseconds, iterations;  ///< medians
};
StepCost stepCost(const Problem& problem, const TetMesh& mesh, double poisson_ratio, Pressure pressure, Method method,
                  int steps);

/// What a cut does to the body as it is loaded, as shares of its elastic energy before.
struct CutEffect {
  double added;    ///< elastic energy that the cut adds, before anything has moved
  double kinetic;  ///< kinetic energy after the next step of 0.01 s
};
CutEffect cutUnderLoad(const Problem& problem, const TetMesh& mesh, double poisson_ratio, Pressure pressure,
                       const PlaneCut& cut);

}  // namespace incision::report
