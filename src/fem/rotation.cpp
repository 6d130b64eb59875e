#include "incision/fem/rotation.h"

#include <Eigen/Geometry>
#include <Eigen/LU>
#include <Eigen/SVD>
#include <algorithm>
#include <cmath>

#include "lanes.h"

namespace incision {
namespace {

/// Newton's iteration doubles its digits each time; from a rotation off by 0.3 rad four get to rounding.
constexpr int MAX_ITERATIONS = 4;

/// Turn [rad] of the last iteration below which the next would change nothing: its square is rounding.
constexpr double LAST_TURN = 1e-8;

/// Turns further than this in one iteration are outside the region where Newton's iteration is trusted.
constexpr double MAX_TURN = 0.5;

bool all(const decltype(Lanes() > Lanes())& condition) {
  for (int l = 0; l < LANES; ++l)
    if (!condition[l]) return false;
  return true;
}

/// Newton's step of polarRotation: half the turn, in `a`, and whether G is positive definite in every lane.
bool halfTurn(const LaneMatrix& R, const LaneMatrix& F, Lanes (&a)[3]) {
  LaneMatrix A;
  multiplyTransposed(R, F, A);
  const Lanes g00 = A[1][1] + A[2][2], g11 = A[0][0] + A[2][2], g22 = A[0][0] + A[1][1];
  const Lanes g01 = -0.5 * (A[0][1] + A[1][0]), g02 = -0.5 * (A[0][2] + A[2][0]), g12 = -0.5 * (A[1][2] + A[2][1]);
  const Lanes c00 = g11 * g22 - g12 * g12, c01 = g02 * g12 - g01 * g22, c02 = g01 * g12 - g02 * g11;
  const Lanes c11 = g00 * g22 - g02 * g02, c12 = g01 * g02 - g00 * g12, c22 = g00 * g11 - g01 * g01;
  const Lanes determinant = g00 * c00 + g01 * c01 + g02 * c02, zero = Lanes();
  if (!all(g00 > zero) || !all(c22 > zero) || !all(determinant > zero)) return false;
  const Lanes w[3] = {A[2][1] - A[1][2], A[0][2] - A[2][0], A[1][0] - A[0][1]};
  const Lanes half = 0.5 / determinant;
  a[0] = half * (c00 * w[0] + c01 * w[1] + c02 * w[2]);
  a[1] = half * (c01 * w[0] + c11 * w[1] + c12 * w[2]);
  a[2] = half * (c02 * w[0] + c12 * w[1] + c22 * w[2]);
  return true;
}

/// R Q with the rotation Q = 1 + s ([a]× + [a]×²), s = 2/(1 + a·a), of the quaternion (1, a).
void turn(const Lanes (&a)[3], LaneMatrix& R) {
  const Lanes n = a[0] * a[0] + a[1] * a[1] + a[2] * a[2], s = 2 / (1 + n), d = 1 - s * n;
  const LaneMatrix Q = {{d + s * a[0] * a[0], s * (a[0] * a[1] - a[2]), s * (a[0] * a[2] + a[1])},
                        {s * (a[0] * a[1] + a[2]), d + s * a[1] * a[1], s * (a[1] * a[2] - a[0])},
                        {s * (a[0] * a[2] - a[1]), s * (a[1] * a[2] + a[0]), d + s * a[2] * a[2]}};
  LaneMatrix turned;
  multiply(R, Q, turned);
  std::copy_n(&turned[0][0], 9, &R[0][0]);
}

/// R (3 − RᵀR)/2, which takes back what rounding has added to R.
void normalise(LaneMatrix& R) {
  LaneMatrix correction, corrected;
  multiplyTransposed(R, R, correction);
  for (int i = 0; i < 3; ++i)
    for (int j = 0; j < 3; ++j) correction[i][j] = (i == j ? 1.5 : 0.0) - 0.5 * correction[i][j];
  multiply(R, correction, corrected);
  std::copy_n(&corrected[0][0], 9, &R[0][0]);
}

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

void polarRotations(const Mat3* F, Mat3* R) {
  LaneMatrix f, r;
  load([&](int l) -> const Mat3& { return F[l]; }, f);
  load([&](int l) -> const Mat3& { return R[l]; }, r);
  const Lanes most = Lanes() + MAX_TURN * MAX_TURN / 4, least = Lanes() + LAST_TURN * LAST_TURN / 4;
  Lanes a[3];
  for (int i = 0; i < MAX_ITERATIONS && halfTurn(r, f, a); ++i) {
    const Lanes square = a[0] * a[0] + a[1] * a[1] + a[2] * a[2];
    if (!all(square < most)) break;
    turn(a, r);
    if (!all(square < least)) continue;
    normalise(r);
    return store(r, [&](int l) -> Mat3& { return R[l]; });
  }
  for (int l = 0; l < LANES; ++l) R[l] = polarRotation(F[l], R[l]);
}

}  // namespace incision
