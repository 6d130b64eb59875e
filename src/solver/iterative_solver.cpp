#include "incision/solver/iterative_solver.h"

#include <Eigen/LU>
#include <algorithm>
#include <cmath>
#include <limits>

#include "incision/fem/parallel.h"

namespace incision {
namespace {

/// Iterations of one run of conjugate gradients. Scenes take 30 to 150; more means that float has lost the direction
/// and a fresh residual does better.
constexpr int MAX_ITERATIONS = 400;

/// A run must leave less than this of the residual to be followed by another: float has lost what it does not gain.
constexpr double MIN_PROGRESS = 0.3;

/// What one run may gain at most: float vectors know no more.
constexpr double MIN_GAIN = 1e-5;

/// A run aims below the tolerance by this much, since the float matrix is not quite A.
constexpr double MARGIN = 0.7;

}  // namespace

void IterativeSolver::topologyChanged(const Assembly& assembly, const std::vector<bool>& held,
                                      const std::vector<int>& piece, const SystemFactors& factors) {
  assembly_ = &assembly;
  factors_ = factors;
  aggregates_ = aggregate(assembly.mesh(), held);
  findPattern(assembly, aggregates_.copies, &pattern_);
  const std::vector<double> diagonal = diagonalScale(assembly, factors);
  const int rows = pattern_.rows();
  scale_.resize(rows);
  for (int i = 0; i < rows; ++i) scale_[i] = 1 / std::sqrt(diagonal[pattern_.copies[i]]);
  norms_.topologyChanged(assembly, pattern_.copies, piece, diagonal);
  inverse_diagonal_.resize(rows);
  for (auto* v : {&y_, &r_, &z_}) v->assign(rows, Vec3::Zero());
  for (auto* v : {&p_, &Ap_}) v->assign(rows, Eigen::Vector4f::Zero());
  if (rows > 0) coarse_.topologyChanged(pattern_, aggregates_, scale_);
}

bool IterativeSolver::matrixChanged(const std::vector<Vec3>& x) {
  if (pattern_.rows() == 0) return true;
  assembler_.assemble(*assembly_, pattern_, factors_, scale_, &blocks_);
  parallelFor(pattern_.rows(), assembly_->threads(), [&](int i) {
    const Eigen::Map<const Eigen::Matrix<float, 4, 3>> block(
        &blocks_[static_cast<std::size_t>(BLOCK_SIZE) * pattern_.diagonal[i]]);
    inverse_diagonal_[i] = block.topRows<3>().cast<double>().inverse();
  });
  coarse_.matrixChanged(x, blocks_, assembly_->threads());
  return true;
}

SolveStats IterativeSolver::solve(const Residual& residual, const std::vector<double>& rounding,
                                  std::vector<Vec3>* dv) {
  SolveStats stats;
  if (pattern_.rows() == 0) return stats;
  std::vector<Vec3>& guess = z_;
  for (int i = 0; i < pattern_.rows(); ++i) {
    Vec3& value = (*dv)[pattern_.copies[i]];
    guess[i] = value;
    value.setZero();
  }
  takeResidual(residual, *dv);
  norms_.setRightHandSide(r_, rounding, tolerance_);
  if (norms_.total() == 0) return stats;
  const double from_zero = norms_.worstRatio(r_);
  for (int i = 0; i < pattern_.rows(); ++i) (*dv)[pattern_.copies[i]] = guess[i];
  takeResidual(residual, *dv);
  stats.residual = norms_.worstRatio(r_);
  if (!(stats.residual < from_zero)) {
    for (int c : pattern_.copies) (*dv)[c].setZero();
    takeResidual(residual, *dv);
    stats.residual = from_zero;
  }
  double before = std::numeric_limits<double>::infinity();
  while (stats.residual > tolerance_ && stats.residual < MIN_PROGRESS * before) {
    before = stats.residual;
    stats.iterations += iterate(std::max(MARGIN * tolerance_, MIN_GAIN * stats.residual));
    for (int i = 0; i < pattern_.rows(); ++i) (*dv)[pattern_.copies[i]] += scale_[i] * y_[i];
    takeResidual(residual, *dv);
    stats.residual = norms_.worstRatio(r_);
  }
  stats.converged = stats.residual <= tolerance_;
  return stats;
}

void IterativeSolver::takeResidual(const Residual& residual, const std::vector<Vec3>& dv) {
  residual(dv, &nodal_residual_);
  parallelFor(pattern_.rows(), assembly_->threads(),
              [&](int i) { r_[i] = scale_[i] * nodal_residual_[pattern_.copies[i]]; });
}

template <typename Function>
double IterativeSolver::sumOverAggregates(const Function& f) {
  return parallelSum(aggregates_.count(), assembly_->threads(), &terms_, [&](int a) {
    double sum = 0;
    for (int i = aggregates_.start[a]; i < aggregates_.start[a + 1]; ++i) sum += f(i);
    return sum;
  });
}

/// Solves Â y = r̂ until every piece's ratio is below `target`; r_ becomes the residual of the float matrix.
int IterativeSolver::iterate(double target) {
  for (Vec3& y : y_) y.setZero();
  for (Eigen::Vector4f& p : p_) p.setZero();
  double rz = 0, beta = 0;
  for (int iteration = 0; iteration < MAX_ITERATIONS; ++iteration) {
    const double next_rz = applyPreconditioner();
    beta = iteration > 0 ? next_rz / rz : 0;
    rz = next_rz;
    if (!(rz > 0)) return iteration;
    parallelFor(pattern_.rows(), assembly_->threads(),
                [&](int i) { p_[i].head<3>() = (z_[i] + beta * p_[i].head<3>().cast<double>()).cast<float>(); });
    const double pAp = sumOverAggregates([&](int i) {
      Eigen::Vector4f sum = Eigen::Vector4f::Zero();
      for (int k = pattern_.row_start[i]; k < pattern_.row_start[i + 1]; ++k) {
        const Eigen::Map<const Eigen::Matrix<float, 4, 3>, Eigen::Aligned16> A(
            &blocks_[static_cast<std::size_t>(BLOCK_SIZE) * k]);
        const Eigen::Vector4f& p = p_[pattern_.column[k]];
        sum += A.col(0) * p[0] + A.col(1) * p[1] + A.col(2) * p[2];
      }
      Ap_[i] = sum;
      return static_cast<double>(p_[i].dot(sum));
    });
    if (!(pAp > 0)) return iteration;
    const double alpha = rz / pAp;
    const double rr = sumOverAggregates([&](int i) {
      y_[i] += alpha * p_[i].head<3>().cast<double>();
      r_[i] -= alpha * Ap_[i].head<3>().cast<double>();
      return r_[i].squaredNorm();
    });
    if (std::sqrt(rr) <= target * norms_.total() && norms_.worstRatio(r_) <= target) return iteration + 1;
  }
  return MAX_ITERATIONS;
}

/// z = (block Jacobi + coarse space) r; returns r·z.
double IterativeSolver::applyPreconditioner() {
  parallelFor(aggregates_.count(), assembly_->threads(), [&](int a) { coarse_.restrictAggregate(a, r_); });
  coarse_.solve();
  return parallelSum(aggregates_.count(), assembly_->threads(), &terms_, [&](int a) {
    double sum = 0;
    for (int i = aggregates_.start[a]; i < aggregates_.start[a + 1]; ++i) {
      z_[i] = inverse_diagonal_[i] * r_[i] + coarse_.prolong(a, i);
      sum += r_[i].dot(z_[i]);
    }
    return sum;
  });
}

}  // namespace incision
