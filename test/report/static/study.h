#pragma once

#include "report/findings.h"
#include "report/static/gmsh.h"
#include "report/static/problem.h"

namespace incision::report {

/// What one static solve gave and took.
struct Solution {
  double energy;  ///< strain energy [J]
  double ms;      ///< median wall time
  int freedoms, iterations, parts_split;
  bool gave_up;  ///< whether the iteration did, and the factorisation took over
};

/// Makes the body from a mesh in memory, cuts it, with cracks that are `longer` by so much [m], assembles and solves.
/// Throws InputError when it cannot.
Solution solve(const TetMesh& mesh, const Case& problem, double longer, int repeats, Method method = Method::AUTO);

/// Errors of one quantity on meshes made in one way, from coarse to fine.
struct Curve {
  std::vector<double> edges;   ///< [m]
  std::vector<double> errors;  ///< relative, signed

  /// The slope of log |error| over log edge, between the first and the last of the finest four.
  double order() const;
  /// The error at edge 0, by the straight line through the finest four over edge^order.
  double limit(double order) const;
  /// |error| at an edge of 1, by the finest mesh.
  double constant(double order) const;
};

/// Runs a problem on all its meshes; data["problems"] and the claims get what it finds.
void study(const Problem& problem, Gmsh* gmsh, Findings* findings);

/// data["bending"]: a field that is known everywhere.
void studyBending(Gmsh* gmsh, Findings* findings);

/// Claims from data["problems"].
void claimConvergence(Findings* findings);

/// data["solvers"]: the time of either solver.
void compareSolvers(Findings* findings);

}  // namespace incision::report
