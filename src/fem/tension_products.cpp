// What resists the turning of parts that are under tension.
#include <algorithm>
#include <cmath>

#include "incision/base/parallel.h"
#include "incision/fem/assembly.h"
#include "stress_lanes.h"

namespace incision {
namespace {

/// Newton's steps towards the principal stress that is farthest from the others. From its upper bound they double their
/// digits, from a first one.
constexpr int NEWTON_STEPS = 5;

/// Added to what is divided by: where all three principal stresses are nearly equal, which have one sign then, they
/// need not be told apart; and the second is nothing beside any stress, but zero over it is zero.
constexpr double ALIKE = 1e-12, TINY = 1e-280;

/// S⁺ = keeps S + share (S² − sum S + product 1), as λ_i (S − λ_j)(S − λ_k) / ((λ_i − λ_j)(λ_i − λ_k)) is what S has
/// along its axis i.
struct PositivePart {
  double keeps, share, sum, product;
};

/// Of principal stresses a ≥ b ≥ c: all but the one that is negative, or the one alone that is positive.
PositivePart positivePart(double a, double b, double c) {
  if (b > 0) return {1, c < 0 ? c / (c - b) / (a - c) : 0, a + b, a * b};
  return {0, a > 0 ? a / (a - b) / (a - c) : 0, b + c, b * c};
}

/// Replaces symmetric S by its positive part. The principal stress that is farthest from the others is a simple root of
/// the characteristic polynomial r³ − t r² + q r − d, the largest one if S is taken with the right sign; the others are
/// then those of a quadratic equation.
void takePositivePart(LaneMatrix& S) {
  const Lanes minor = S[1][1] * S[2][2] - S[1][2] * S[2][1];
  const Lanes det = S[0][0] * minor + S[0][1] * (S[1][2] * S[2][0] - S[1][0] * S[2][2]) +
                    S[0][2] * (S[1][0] * S[2][1] - S[1][1] * S[2][0]);
  const Lanes q = S[0][0] * S[1][1] - S[0][1] * S[1][0] + S[0][0] * S[2][2] - S[0][2] * S[2][0] + minor;
  const Lanes trace = S[0][0] + S[1][1] + S[2][2];
  const Lanes skew = trace * (2.0 * trace * trace - 9.0 * q) + 27.0 * det, spread = trace * trace - 3.0 * q;
  Lanes sign, root, half_gap;
  for (int l = 0; l < LANES; ++l) sign[l] = skew[l] < 0 ? -1 : 1;
  const Lanes t = sign * trace, d = sign * det;
  for (int l = 0; l < LANES; ++l) root[l] = (t[l] + 2 * std::sqrt(std::max(spread[l], 0.0))) / 3;
  const Lanes least_slope = ALIKE * t * t + TINY;
  for (int k = 0; k < NEWTON_STEPS; ++k)
    root -= (((root - t) * root + q) * root - d) / ((3.0 * root - 2.0 * t) * root + q + least_slope);
  const Lanes middle = (t - root) / 2.0, square_of_gap = middle * middle - (q - root * (t - root));
  for (int l = 0; l < LANES; ++l) half_gap[l] = std::sqrt(std::max(square_of_gap[l], 0.0));
  const Lanes next = middle + half_gap, last = middle - half_gap;
  Lanes keeps, share, sum, product;
  for (int l = 0; l < LANES; ++l) {
    const PositivePart part =
        sign[l] > 0 ? positivePart(root[l], next[l], last[l]) : positivePart(-last[l], -next[l], -root[l]);
    keeps[l] = part.keeps, share[l] = part.share, sum[l] = part.sum, product[l] = part.product;
  }
  LaneMatrix square;
  multiply(S, S, square);
  for (int i = 0; i < 3; ++i)
    for (int j = 0; j < 3; ++j)
      S[i][j] = share * square[i][j] + (keeps - share * sum) * S[i][j] + (i == j ? share * product : Lanes());
}

}  // namespace

void Assembly::tensionProducts(const std::vector<Vec3>& x, double factor, const std::vector<char>& wanted,
                               std::vector<TensionProducts>* products) const {
  const int parts = static_cast<int>(rotations_.size());
  products->resize(rotations_.size());
  if (patches_) averageDilatations(x);
  parallelFor(groups(), threads_, [&](int group) {
    const int first = LANES * group, count = std::min(LANES, parts - first);
    for (int l = 0; l < count; ++l) (*products)[first + l].pairs.fill(0);
    if (std::count(wanted.begin() + first, wanted.begin() + first + count, 0) == count) return;
    StressLanes lanes;
    findStress(first, count, x, lanes);
    takePositivePart(lanes.stress);
    LaneMatrix Sb, bSb;  // b holds b_1, b_2, b_3 as its columns
    multiply(lanes.stress, lanes.b, Sb);
    multiplyTransposed(lanes.b, Sb, bSb);
    for (int l = 0; l < count; ++l) {
      if (!wanted[first + l]) continue;
      std::array<double, 6>& of_part = (*products)[first + l].pairs;
      for (int J = 0; J < 3; ++J) of_part[J] = -factor * (bSb[0][J][l] + bSb[1][J][l] + bSb[2][J][l]);
      of_part[3] = factor * bSb[0][1][l];
      of_part[4] = factor * bSb[0][2][l];
      of_part[5] = factor * bSb[1][2][l];
    }
  });
}

void Assembly::multiplyTension(const std::vector<TensionProducts>& products, const std::vector<Vec3>& w,
                               std::vector<Vec3>* result) const {
  const int parts = static_cast<int>(products.size());
  parallelFor(run_sums_.runs(), threads_, [&](int run) {
    run_sums_.clear(run);
    for (int p = RunSums::RUN * run; p < std::min(parts, RunSums::RUN * (run + 1)); ++p) {
      const auto& c = mesh_.parts()[p].copies;
      const auto& [k_01, k_02, k_03, k_12, k_13, k_23] = products[p].pairs;
      const Vec3 w_01 = k_01 * (w[c[1]] - w[c[0]]), w_02 = k_02 * (w[c[2]] - w[c[0]]),
                 w_03 = k_03 * (w[c[3]] - w[c[0]]), w_12 = k_12 * (w[c[2]] - w[c[1]]),
                 w_13 = k_13 * (w[c[3]] - w[c[1]]), w_23 = k_23 * (w[c[3]] - w[c[2]]);
      run_sums_.at(p, 0) += w_01 + w_02 + w_03;
      run_sums_.at(p, 1) += w_12 + w_13 - w_01;
      run_sums_.at(p, 2) += w_23 - w_02 - w_12;
      run_sums_.at(p, 3) -= w_03 + w_13 + w_23;
    }
  });
  run_sums_.gather(result, threads_);
}

}  // namespace incision
