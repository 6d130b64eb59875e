#pragma once

#include <Eigen/Core>
#include <vector>

#include "incision/fem/material.h"
#include "incision/mesh/tet_mesh.h"

namespace incision {

/// Gradients b_I = ∇N_I of a linear tetrahedron's shape functions as columns [1/m].
using Gradients = Eigen::Matrix<double, 3, 4>;

/// The element at rest.
struct RestElement {
  Gradients b;
  double volume;  ///< V_e [m³]
};

std::vector<RestElement> restElements(const TetMesh& mesh);

/// Σ_I y_I b_Iᵀ: the gradient of a field given at an element's four copies; F where y are their positions.
inline Mat3 gradient(const Vec3& y0, const Vec3& y1, const Vec3& y2, const Vec3& y3, const Gradients& b) {
  return y0 * b.col(0).transpose() + y1 * b.col(1).transpose() + y2 * b.col(2).transpose() + y3 * b.col(3).transpose();
}

/// Stress [Pa] in the unrotated frame for RᵀF: σ = λ tr(ε) I + 2 μ ε, ε = sym(RᵀF) − I.
inline Mat3 corotatedStress(const Mat3& RtF, const Material& material) {
  const Mat3 strain = 0.5 * (RtF + RtF.transpose()) - Mat3::Identity();
  return material.lambda() * strain.trace() * Mat3::Identity() + 2 * material.mu() * strain;
}

}  // namespace incision
