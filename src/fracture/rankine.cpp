#include "incision/fracture/rankine.h"

#include <Eigen/Eigenvalues>

namespace incision {

std::vector<Strength> strengthsOf(const FractureSettings& settings, const Regions& regions) {
  const auto tensile = regions.values(settings.tensile_strength, &RegionSettings::tensile_strength);
  const auto compressive = regions.values(settings.compressive_strength, &RegionSettings::compressive_strength);
  std::vector<Strength> strengths;
  for (int r = 0; r < regions.count(); ++r) strengths.push_back({tensile[r], compressive[r]});
  return strengths;
}

Loading rankine(const Mat3& stress, const Strength& strength) {
  Eigen::SelfAdjointEigenSolver<Mat3> principal;
  principal.computeDirect(stress, Eigen::EigenvaluesOnly);
  const double smallest = principal.eigenvalues()[0], largest = principal.eigenvalues()[2];
  const double tension = largest / strength.tensile, compression = -smallest / strength.compressive;
  if (compression > tension && compression > 0) return {compression, smallest, FailureKind::COMPRESSION};
  if (tension > 0) return {tension, largest, FailureKind::TENSION};
  return {};
}

// The iteration, as the closed form loses digits where two principal stresses are close.
Vec3 crackNormal(const Mat3& stress) { return Eigen::SelfAdjointEigenSolver<Mat3>(stress).eigenvectors().col(2); }

}  // namespace incision
