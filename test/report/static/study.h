#pragma once

#include "report/section.h"
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

/// Runs a problem on all its meshes, and gives the errors of its quantities.
nlohmann::json study(const Problem& problem, Gmsh* gmsh, bool quick);

/// The error of a field that is known everywhere.
nlohmann::json studyBending(Gmsh* gmsh, bool quick);

/// The time of either solver.
nlohmann::json compareSolvers(bool quick);

}  // namespace incision::report
