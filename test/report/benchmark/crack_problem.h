#pragma once

#include <array>
#include <optional>
#include <string>

#include "report/benchmark/round_crack.h"

namespace incision::report {

/// K_I, K_II and K_III [Pa √m].
using Intensities = std::array<double, 3>;

/// A round crack in a large block under uniform stress far away.
struct CrackProblem {
  std::string name, published;
  RoundCrack crack;
  Mat3 stress;  ///< far away [Pa]
  double young_modulus, poisson_ratio;
  Intensities answer;  ///< the largest along the front
  bool sheared;        ///< K_II goes with cos ω and K_III with sin ω; otherwise they are the same all along the front
  std::optional<double> rate = {};  ///< energy release rate, mean along the front [J/m²]
  std::optional<Mat3> moment = {};  ///< ∫ [u] ⊗ n dA in infinite space [m³], where it is known

  /// This problem with another radius of its crack, for which only the crack and its moment are right.
  CrackProblem scaled(double by) const;
};

CrackProblem straightPenny();  ///< a disc across the tension
CrackProblem inclinedPenny();  ///< at 45° to it
CrackProblem lens();           ///< a cap of a sphere under tension from all sides

/// A block with its centre at the origin, and the edge of its cells round the crack [m].
struct Block {
  TetMesh mesh;
  double half, edge;
};

/// A block four radii to each side; so many cells lie along each side, most of them round the crack.
Block blockRound(const RoundCrack& crack, int cells);

/// Displacement [m] of uniform stress, and of a small crack at the origin with this moment (Mura, Micromechanics of
/// Defects in Solids: eigenstrains of a point).
Vec3 uniformField(const CrackProblem& problem, const Vec3& X);
Vec3 farField(const CrackProblem& problem, const Mat3& moment, const Vec3& X);

}  // namespace incision::report
