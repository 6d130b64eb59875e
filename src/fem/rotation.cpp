#include "incision/fem/rotation.h"

#include <Eigen/Geometry>
#include <Eigen/LU>
#include <Eigen/SVD>
#include <cmath>

namespace incision {
namespace {

/// Newton's iteration doubles its digits each time; from a rotation off by 0.3 rad four get to rounding.
constexpr int MAX_ITERATIONS = 4;

/// Turn [rad] of the last iteration below which the next would change nothing: its square is rounding.
constexpr double LAST_TURN = 1e-8;

/// Turns further than this in one iteration are outside the region where Newton's iteration is trusted.
constexpr double MAX_TURN = 0.5;

Mat3 rotationBySvd(const Mat3& F) {
  const Eigen::JacobiSVD<Mat3> svd(F, Eigen::ComputeFullU | Eigen::ComputeFullV);
  Mat3 U = svd.matrixU();
  if ((U * svd.matrixV().transpose()).determinant() < 0) U.col(2) = -U.col(2);
  return U * svd.matrixV().transpose();
}

}  // namespace

// With A = RᵀF, S its symmetric part and [w]× = A − Aᵀ, turning R to R exp([ω]×) changes tr(RᵀF) by
//   w·ω − ½ ωᵀ G ω + O(ω³),  G = tr(S) I − S.
// Newton's step is ω = G⁻¹ w. Where w = 0 and G is positive definite R is the maximum, and the only one.
Mat3 polarRotation(const Mat3& F, const Mat3& guess) {
  Mat3 R = guess;
  for (int i = 0; i < MAX_ITERATIONS; ++i) {
    const Mat3 A = R.transpose() * F;
    const Mat3 S = 0.5 * (A + A.transpose());
    const Mat3 G = S.trace() * Mat3::Identity() - S;
    const Vec3 w(A(2, 1) - A(1, 2), A(0, 2) - A(2, 0), A(1, 0) - A(0, 1));
    const bool positive_definite = G(0, 0) > 0 && G(0, 0) * G(1, 1) - G(0, 1) * G(0, 1) > 0 && G.determinant() > 0;
    if (!positive_definite) break;
    const Vec3 turn = G.inverse() * w;
    const double angle = turn.norm();
    if (!(angle < MAX_TURN)) break;
    R = R * Eigen::Quaterniond(1, turn.x() / 2, turn.y() / 2, turn.z() / 2).normalized().toRotationMatrix();
    if (angle < LAST_TURN) return 0.5 * R * (3 * Mat3::Identity() - R.transpose() * R);
  }
  return rotationBySvd(F);
}

}  // namespace incision
