#include "incision/fracture/rankine.h"

#include <Eigen/Eigenvalues>

namespace incision {

Loading rankine(const Mat3& stress, const FractureSettings& settings) {
  Eigen::SelfAdjointEigenSolver<Mat3> principal;
  principal.computeDirect(stress, Eigen::EigenvaluesOnly);
  const double smallest = principal.eigenvalues()[0], largest = principal.eigenvalues()[2];
  const double tension = largest / settings.tensile_strength, compression = -smallest / settings.compressive_strength;
  if (compression > tension && compression > 0) return {compression, smallest, FailureKind::COMPRESSION};
  if (tension > 0) return {tension, largest, FailureKind::TENSION};
  return {};
}

// The iteration, as the closed form loses digits where two principal stresses are close.
Vec3 crackNormal(const Mat3& stress) { return Eigen::SelfAdjointEigenSolver<Mat3>(stress).eigenvectors().col(2); }

}  // namespace incision
