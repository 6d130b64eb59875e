#pragma once

namespace incision {

enum class Method { AUTO, DIRECT, ITERATIVE };

struct SolverSettings {
  double time_step = 0.01;  ///< Δt [s], in [1e-6, 1]
  Method method = Method::AUTO;
  double tolerance = 1e-6;  ///< relative residual of iterative solves, in [1e-12, 1e-1]
  int threads = 2;          ///< in [1, 64]
};

}  // namespace incision
