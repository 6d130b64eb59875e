#pragma once

#include "report/locking/problem.h"

namespace incision::report {

/// The better known remedy, measured beside ours: the dilatation averaged over the parts round each copy, θ_c = Σ_p
/// V_p/4 θ_p / V_c with V_c = Σ_p V_p/4, in the energy Σ_p V_p μ ε:ε + Σ_c V_c ½ λ θ_c².
struct NodalAverage {
  double answer;  ///< what the problem asks [m]; it has a load
  long blocks;    ///< in the matrix
};
NodalAverage nodalAverage(const Problem& problem, const TetMesh& mesh, double poisson_ratio);

}  // namespace incision::report
