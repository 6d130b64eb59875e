// Bounds of the parts' principal stresses, for which no rotation is needed.
#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <limits>

#include "incision/base/parallel.h"
#include "incision/fem/assembly.h"

namespace incision {
namespace {

/// Square of the strain measure |C − 1| up to which there are bounds: no stretch is then outside [0.70, 1.23].
constexpr double MOST_STRAIN = 0.25;

/// With such stretches (U − 1)² / 2 has at most this trace for |C − 1| = 1.
constexpr double CURVATURE = 0.172;

/// The largest of three numbers that sum to zero is at most √(2/3) times their length; a little more, since the closed
/// form of the principal stresses loses digits.
constexpr double LARGEST = 0.8166;

/// Strain that covers the rounding of a stress and of its mean.
constexpr double ROUNDING = 1e-9;

/// The half trace of C − 1, half its largest deviation from a third of that, and how far the stretches may be from
/// where these put them: infinite where the part is stretched too far or inverted.
struct Strains {
  double dilatation, deviation, spread;
};

/// C = FᵀF = U² does without the rotation, and U − 1 = (C − 1) / 2 − (U − 1)² / 2. Without warping the strain is sym(F)
/// − 1, and C stands for F + Fᵀ − 1.
Strains strainsOf(const Vec3& f0, const Vec3& f1, const Vec3& f2, bool warping) {
  double c0 = f0.dot(f0) - 1, c1 = f1.dot(f1) - 1, c2 = f2.dot(f2) - 1;
  double c01 = f0.dot(f1), c02 = f0.dot(f2), c12 = f1.dot(f2);
  if (!warping) {
    c0 = 2 * (f0[0] - 1), c1 = 2 * (f1[1] - 1), c2 = 2 * (f2[2] - 1);
    c01 = f0[1] + f1[0], c02 = f0[2] + f2[0], c12 = f1[2] + f2[1];
  }
  const double trace = c0 + c1 + c2, square = c0 * c0 + c1 * c1 + c2 * c2 + 2 * (c01 * c01 + c02 * c02 + c12 * c12);
  const double deviation = LARGEST / 2 * std::sqrt(std::max(square - trace * trace / 3, 0.0));
  if (!(square < MOST_STRAIN) || (warping && !(f0.dot(f1.cross(f2)) > 0)))
    return {trace / 2, deviation, std::numeric_limits<double>::infinity()};
  return {trace / 2, deviation, (warping ? CURVATURE * square : 0) + ROUNDING};
}

}  // namespace

// The principal values of σ = λ tr(U − 1) + 2 μ (U − 1).
void Assembly::principalBounds(const std::vector<Vec3>& x, std::vector<PrincipalBounds>* bounds) const {
  const std::vector<Part>& parts = mesh_.parts();
  bounds->resize(parts.size());
  if (patches_) {
    dilatations_.resize(parts.size());
    dilatation_spreads_.resize(parts.size());
  }
  parallelFor(static_cast<int>(parts.size()), threads_, [&](int p) {
    const Part& part = parts[p];
    const TissueElement& element = elements_[part.element];
    const Vec3& origin = x[part.copies[0]];
    const Vec3 a = x[part.copies[1]] - origin, b = x[part.copies[2]] - origin, c = x[part.copies[3]] - origin;
    const auto column = [&](int j) -> Vec3 { return element.b(j, 0) * a + element.b(j, 1) * b + element.b(j, 2) * c; };
    const Strains strains = strainsOf(column(0), column(1), column(2), warping_);
    const double lambda = patches_ ? 0 : element.lame.lambda, mu = element.lame.mu;
    const double middle = (lambda + 2 * mu / 3) * strains.dilatation;
    const double around = 2 * mu * strains.deviation + (std::abs(lambda) + 2 * mu) * strains.spread;
    (*bounds)[p] << middle - around, middle + around;
    if (!patches_) return;
    dilatations_[p] = strains.dilatation;
    dilatation_spreads_[p] = strains.spread;
  });
  if (patches_) addMeanDilatations(bounds);
}

/// What λ times the mean dilatation of its patch adds to each part.
void Assembly::addMeanDilatations(std::vector<PrincipalBounds>* bounds) const {
  parallelFor(patches_->count(), threads_, [&](int a) {
    double gained = 0, spread = 0, whole = 0;
    for (int p : patches_->parts()[a]) {
      const double V = volume(p);
      gained += V * dilatations_[p];
      spread += V * dilatation_spreads_[p];
      whole += V;
    }
    for (int p : patches_->parts()[a]) {
      const double lambda = lameOf(p).lambda, middle = lambda * gained / whole;
      const double around = lambda != 0 ? std::abs(lambda) * spread / whole : 0;  // the spread may be infinite
      (*bounds)[p] += PrincipalBounds(middle - around, middle + around);
    }
  });
}

}  // namespace incision
