#pragma once

#include "report/locking/problem.h"

namespace incision::report {

/// The answer of CalculiX, which must be installed, on quadratic bricks with reduced integration (C3D20R): `cells`
/// along the longest side of the box, cubes nearly. Throws std::runtime_error when the program fails.
double reference(const Problem& problem, double poisson_ratio, int cells);

}  // namespace incision::report
