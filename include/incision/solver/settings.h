#pragma once

#include <optional>

#include "incision/base/range.h"
#include "incision/fem/tension_scheme.h"

namespace incision {

class YamlValue;

enum class Method { AUTO, DIRECT, ITERATIVE };

/// Implicit Euler is of first order and damps; BDF2 is of second, but for steps in which something is touched or cut.
enum class Integrator { EULER, BDF2 };

struct SolverSettings {
  static constexpr Range TIME_STEP = {1e-6, 1};
  static constexpr Range TOLERANCE = {1e-12, 1e-1};
  static constexpr int MAX_THREADS = 64;
  static constexpr int MAX_ITERATIONS = 1000000;

  double time_step = 0.01;  ///< Δt [s], in TIME_STEP
  Method method = Method::AUTO;
  double tolerance = 1e-6;  ///< relative residual of iterative solves, in TOLERANCE
  int threads = 2;          ///< from 1 to MAX_THREADS
  Integrator integrator = Integrator::EULER;
  TensionScheme tension = TensionScheme::AUTO;
  /// With so many iterations, from 1 to MAX_ITERATIONS, a step ends with what it has; none: it goes on to the
  /// tolerance.
  std::optional<int> iterations = {};
};

/// The section `solver`. Throws InputError.
SolverSettings parseSolver(const YamlValue& value);

}  // namespace incision
