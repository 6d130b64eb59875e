#include "incision/fem/linear_tet.h"

#include <Eigen/LU>
#include <cmath>

namespace incision {

std::vector<RestElement> restElements(const TetMesh& mesh) {
  std::vector<RestElement> rest(mesh.elements.size());
  for (std::size_t e = 0; e < rest.size(); ++e) {
    const auto& nodes = mesh.elements[e];
    Mat3 Dm;
    for (int k = 0; k < 3; ++k) Dm.col(k) = mesh.nodes[nodes[k + 1]] - mesh.nodes[nodes[0]];
    // N_1, N_2, N_3 are the affine coordinates D_m⁻¹ (X − X_0), and N_0 is what they lack of 1.
    const Mat3 inverse = Dm.inverse();
    rest[e].b = inverse.transpose();
    rest[e].volume = Dm.determinant() / 6;
  }
  return rest;
}

double vonMises(const Mat3& stress) {
  const Mat3 deviator = stress - stress.trace() / 3 * Mat3::Identity();
  return std::sqrt(1.5 * deviator.squaredNorm());
}

}  // namespace incision
