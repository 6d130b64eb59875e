#pragma once

namespace incision {

enum class Method { AUTO, DIRECT, ITERATIVE };

/// Implicit Euler is of first order and damps; BDF2 is of second, but for steps in which something is touched or cut.
enum class Integrator { EULER, BDF2 };

struct SolverSettings {
  double time_step = 0.01;  ///< Δt [s], in [1e-6, 1]
  Method method = Method::AUTO;
  double tolerance = 1e-6;  ///< relative residual of iterative solves, in [1e-12, 1e-1]
  int threads = 2;          ///< in [1, 64]
  Integrator integrator = Integrator::EULER;
};

}  // namespace incision
