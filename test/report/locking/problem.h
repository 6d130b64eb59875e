#pragma once

#include <array>
#include <string>
#include <vector>

#include "incision/fem/boundary.h"
#include "incision/mesh/grid_mesh.h"

namespace incision::report {

inline constexpr double YOUNG_MODULUS = 1e5;  ///< [Pa]; errors do not depend on it

/// A box of tissue under a small load, and the one number that is asked of it.
struct Problem {
  std::string name;
  Vec3 size, origin;          ///< of the box [m]
  std::array<int, 3> cells;   ///< of the coarsest grid: cubes
  std::vector<Clamp> clamps;  ///< velocities are displacements [m]
  std::vector<Load> loads;    ///< one or none

  /// Whether a plate presses and its force is asked; else the displacement along the load, its mean over the load.
  bool plate() const { return loads.empty(); }
  TetMesh grid(int refinement) const;
  /// About as many elements as the grid has, by Gmsh, which must be installed. Throws std::runtime_error when it fails.
  TetMesh unstructured(int refinement) const;
};

/// Bent by a shear traction on its end.
Problem cantilever();
/// Between two plates that it sticks to.
Problem heldBlock();
/// On a plate that it sticks to, pressed evenly on a quarter of its top.
Problem pressedBlock();

}  // namespace incision::report
