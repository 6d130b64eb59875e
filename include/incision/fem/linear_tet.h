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
  Mat3 b;         ///< b_1, b_2, b_3; the four sum to zero
  double volume;  ///< V_e [m³]

  /// All four.
  Gradients gradients() const {
    Gradients all;
    all << -b.rowwise().sum(), b;
    return all;
  }
};

std::vector<RestElement> restElements(const TetMesh& mesh);

/// Σ_I y_I b_Iᵀ: the gradient of a field given at an element's four copies; F where y are their positions.
inline Mat3 gradient(const Vec3& y0, const Vec3& y1, const Vec3& y2, const Vec3& y3, const RestElement& rest) {
  return (y1 - y0) * rest.b.col(0).transpose() + (y2 - y0) * rest.b.col(1).transpose() +
         (y3 - y0) * rest.b.col(2).transpose();
}

/// ε = sym(RᵀF) − I.
inline Mat3 corotatedStrain(const Mat3& RtF) { return 0.5 * (RtF + RtF.transpose()) - Mat3::Identity(); }

/// Stress [Pa] in the unrotated frame for RᵀF: σ = λ tr(ε) I + 2 μ ε.
inline Mat3 corotatedStress(const Mat3& RtF, const Lame& lame) {
  const Mat3 strain = corotatedStrain(RtF);
  return lame.lambda * strain.trace() * Mat3::Identity() + 2 * lame.mu * strain;
}

/// Stress [Pa] in the unrotated frame for RᵀF and a dilatation θ from elsewhere: σ = λ θ I + 2 μ ε.
inline Mat3 corotatedStress(const Mat3& RtF, double dilatation, const Lame& lame) {
  return lame.lambda * dilatation * Mat3::Identity() + 2 * lame.mu * corotatedStrain(RtF);
}

/// Von Mises' equivalent stress √(3/2 s : s) [Pa] of the deviator s of a stress.
double vonMises(const Mat3& stress);

}  // namespace incision
