#pragma once

#include <nlohmann/json.hpp>

#include "support/rig.h"

namespace incision::report {

/// What one static solve gave and took.
struct Solution {
  std::vector<Vec3> u;  ///< displacement of each node of the mesh [m]
  double energy;        ///< strain energy [J]
  double ms;            ///< median wall time of the job, but for holding_ms
  double holding_ms;    ///< median wall time to find the nodes that each clamp holds
  int freedoms, iterations;
  bool gave_up;  ///< whether the iteration did, and the factorisation took over
};

/// Makes the body from a mesh in memory, assembles and solves. Throws InputError when it cannot.
Solution solve(const TetMesh& mesh, RigSettings settings, int repeats, Method method = Method::AUTO);

/// A point of a curve: what the solve took, and the mesh's size.
nlohmann::json pointOf(const TetMesh& mesh, const Solution& solution);

/// Gmsh's mesh of a script beside the report's sections. Throws std::runtime_error when Gmsh fails.
TetMesh gmshMesh(const std::string& script, int cells);

/// Elements in a box with a stiffness of their own.
RegionSettings tissue(const Place& place, double young_modulus);

/// A hold for each of these nodes, at the end of the one step of a second where the field takes it.
std::vector<Clamp> holdEach(const TetMesh& mesh, const std::function<bool(const Vec3&)>& chosen,
                            const std::function<Vec3(const Vec3&)>& field);

/// Whether a point is on the surface of a box.
bool isOnSurface(const RestBox& box, const Vec3& X);

}  // namespace incision::report
