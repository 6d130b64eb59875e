#pragma once

#include <array>
#include <vector>

#include "incision/mesh/tet_mesh.h"

namespace incision {

/// Vectors a first guess is made of: with the last solution and its first two backward differences it can follow a
/// parabola in time.
inline constexpr int BASIS_SIZE = 3;

/// The vectors that a first guess is made of, by copy.
using Basis = std::array<std::vector<Vec3>, BASIS_SIZE>;

using BasisMatrix = Eigen::Matrix<double, BASIS_SIZE, BASIS_SIZE>;
using BasisVector = Eigen::Matrix<double, BASIS_SIZE, 1>;

/// The c that minimises ½ cᵀ G c − h·c, where G_jk = u_j·A u_k and h_j = u_j·b: the sum Σ c_j u_j is then the nearest
/// to the solution of A x = b in the norm of A. Vectors that hardly add to those before them are left out.
BasisVector bestCombination(const BasisMatrix& G, const BasisVector& h);

}  // namespace incision
