#include "incision/solver/iterative_solver.h"

#include <Eigen/LU>
#include <algorithm>
#include <cmath>
#include <limits>

#include "incision/base/parallel.h"

namespace incision {
namespace {

/// Iterations of one run of conjugate gradients. Scenes take 20 to 150; more means that float has lost the direction
/// and a fresh residual does better.
constexpr int MAX_ITERATIONS = 400;

/// A run must leave less than this of the residual to be followed by another: float has lost what it does not gain.
constexpr double MIN_PROGRESS = 0.3;

/// What one run may gain at most: float vectors know no more.
constexpr double MIN_GAIN = 1e-5;

/// A run aims below the tolerance by this much, since the float matrix is not quite A.
constexpr double MARGIN = 0.7;

/// How much of the tolerance the rounding of a float product may take up.
constexpr double ROUNDING_SHARE = 0.1;

/// Rows that a sum takes together, so that it does not depend on the count of threads.
constexpr int CHUNK = 64;

/// Σ f(row) over all rows.
template <typename Function>
double sumOverRows(int rows, int threads, std::vector<double>* terms, const Function& f) {
  return parallelSum((rows + CHUNK - 1) / CHUNK, threads, terms, [&](int chunk) {
    double sum = 0;
    for (int i = chunk * CHUNK; i < std::min(rows, (chunk + 1) * CHUNK); ++i) sum += f(i);
    return sum;
  });
}

}  // namespace

void IterativeSolver::systemChanged(const Assembly& assembly, const SystemChange& change,
                                    const SystemFactors& factors) {
  const CutMesh& mesh = assembly.mesh();
  if (!assembly_) order_ = orderNodes(mesh.mesh(), leafSize(static_cast<int>(mesh.mesh().nodes.size())));
  assembly_ = &assembly;
  factors_ = factors;
  editPattern(assembly, orderCopies(mesh, order_, change.left_out), change.touched, &pattern_);
  aggregates_ = aggregate(mesh, order_, pattern_);
  const int rows = pattern_.rows();
  scale_.resize(rows);
  parallelFor(rows, assembly.threads(),
              [&](int i) { scale_[i] = 1 / std::sqrt(diagonalOf(assembly, factors, pattern_.copies[i])); });
  rest_x_.clear();
  for (int c = 0; !assembly.warping() && c < mesh.numCopies(); ++c)
    rest_x_.push_back(mesh.mesh().nodes[mesh.copyNode(c)]);
  norms_.systemChanged(assembly, pattern_.copies, change.piece, scale_);
  coupled_ = CoupledRows();
  inverse_diagonal_.resize(rows);
  for (auto* v : {&y_, &r_, &z_, &p_, &Ap_}) v->assign(rows, Vec4f::Zero());
  basis_.fill(y_);
  products_.resize(aggregates_.count());
  group_of_.clear();
  for (int a = 0; a < aggregates_.count(); ++a)
    group_of_.push_back(change.group[pattern_.copies[aggregates_.rows[a][0]]]);
  groups_ = change.group.empty() ? 0 : 1 + *std::max_element(change.group.begin(), change.group.end());
  if (rows > 0) coarse_.topologyChanged(pattern_, aggregates_, scale_);
}

/// Without warping the matrix is that of the body at rest, and so are its rigid modes, wherever the body now is.
void IterativeSolver::matrixChanged(const std::vector<Vec3>& x) {
  if (pattern_.rows() == 0) return;
  assembler_.assemble(*assembly_, pattern_, factors_, scale_, &blocks_);
  parallelFor(pattern_.rows(), assembly_->threads(), [&](int i) { invertDiagonal(i, Mat3::Zero()); });
  coarse_.matrixChanged(assembly_->warping() ? x : rest_x_, blocks_, assembly_->threads());
}

bool IterativeSolver::springsChanged(const std::vector<Spring>& springs, double time_step) {
  if (pattern_.rows() == 0) return true;
  const int threads = assembly_->threads();
  const auto& rows = coupled_.rows();
  parallelFor(static_cast<int>(rows.size()), threads, [&](int k) { invertDiagonal(rows[k], Mat3::Zero()); });
  coupled_.set(springs, time_step, pattern_, scale_);
  parallelFor(static_cast<int>(rows.size()), threads, [&](int k) { invertDiagonal(rows[k], coupled_.diagonal(k)); });
  coarse_.springsChanged(coupled_, threads);
  return true;
}

void IterativeSolver::invertDiagonal(int row, const Mat3& coupled) {
  const Eigen::Map<const Eigen::Matrix3f> block(
      &blocks_[static_cast<std::size_t>(BLOCK_SIZE) * pattern_.diagonal[row]]);
  inverse_diagonal_[row].setZero();
  inverse_diagonal_[row].topRows<3>() = (block.cast<double>() + coupled).inverse().cast<float>();
}

/// Must come before coupled_.multiplyRow.
void IterativeSolver::stretchSprings(const std::vector<Vec4f>& p) {
  parallelFor(coupled_.count(), assembly_->threads(), [&](int c) { coupled_.stretch(c, p); });
}

SolveStats IterativeSolver::solve(const Residual& residual, const std::vector<double>& rounding, const Basis& basis,
                                  std::vector<Vec3>* dv) {
  SolveStats stats;
  if (pattern_.rows() == 0) return stats;
  for (int copy : pattern_.copies) (*dv)[copy].setZero();
  residual(*dv, &residual_);
  norms_.setRightHandSide(residual_, rounding, tolerance_);
  if (norms_.total() == 0) return stats;
  if (floatIsTooCoarse(basis.front())) {
    for (int copy : pattern_.copies) (*dv)[copy] = basis.front()[copy];
    residual(*dv, &residual_);
  }
  scaleResidual();
  guess(basis);
  double before = std::numeric_limits<double>::infinity();
  for (stats.residual = norms_.worstRatio(r_);;) {
    const double target = std::max(MARGIN * tolerance_, MIN_GAIN * stats.residual);
    if (stats.residual > target) stats.iterations += iterate(target);
    parallelFor(pattern_.rows(), assembly_->threads(), [&](int i) {
      (*dv)[pattern_.copies[i]] += norms_.total() * scale_[i] * y_[i].head<3>().cast<double>();
    });
    residual(*dv, &residual_);
    stats.residual = norms_.worstRatio(residual_);
    if (stats.residual <= tolerance_ || !(stats.residual < MIN_PROGRESS * before)) break;
    before = stats.residual;
    scaleResidual();
    std::fill(y_.begin(), y_.end(), Vec4f::Zero());
  }
  stats.converged = stats.residual <= tolerance_;
  return stats;
}

/// Whether the float matrix would leave more rounding in A Δv than the tolerance allows: in a stiff body nearly all of
/// it cancels. The first residual is then reckoned at `dv` itself, and the guess only has to mend it.
bool IterativeSolver::floatIsTooCoarse(const std::vector<Vec3>& dv) {
  const double square = sumOverRows(pattern_.rows(), assembly_->threads(), &terms_, [&](int i) {
    return dv[pattern_.copies[i]].squaredNorm() / (scale_[i] * scale_[i]);
  });
  return std::numeric_limits<float>::epsilon() * std::sqrt(square) > ROUNDING_SHARE * tolerance_ * norms_.total();
}

void IterativeSolver::scaleResidual() {
  parallelFor(pattern_.rows(), assembly_->threads(), [&](int i) {
    r_[i].head<3>() = (scale_[i] / norms_.total() * residual_[pattern_.copies[i]]).cast<float>();
  });
}

/// Takes for y_ the best sum of the basis in each piece, since pieces move by themselves, and for r_ what it leaves of
/// the right-hand side r_.
void IterativeSolver::guess(const Basis& basis) {
  const int threads = assembly_->threads();
  const std::array<std::vector<Vec4f>*, BASIS_SIZE> A_basis = {&z_, &p_, &Ap_};  // not in use yet
  const auto forEachRow = [&](int a, const auto& f) {
    for (int row : aggregates_.rows[a]) f(row);
  };
  for (int j = 0; j < BASIS_SIZE; ++j) {
    double largest = 0;
    for (int copy : pattern_.copies) largest = std::max(largest, basis[j][copy].cwiseAbs().maxCoeff());
    const double unit = largest > 0 ? 1 / largest : 0;
    parallelFor(pattern_.rows(), threads, [&](int i) {
      basis_[j][i].head<3>() = (unit / scale_[i] * basis[j][pattern_.copies[i]]).cast<float>();
    });
  }
  for (int j = 0; j < BASIS_SIZE && coupled_.count() > 0; ++j) {
    stretchSprings(basis_[j]);
    parallelFor(pattern_.rows(), threads, [&](int i) { (*A_basis[j])[i] = coupled_.multiplyRow(i); });
  }
  parallelFor(aggregates_.count(), threads, [&](int a) {
    BasisProducts& sum = products_[a];
    sum = BasisProducts();
    forEachRow(a, [&](int i) {
      for (int j = 0; j < BASIS_SIZE; ++j) {
        Vec4f A_u = multiplyRow(pattern_, blocks_, i, basis_[j]);
        if (coupled_.count() > 0) A_u += (*A_basis[j])[i];
        (*A_basis[j])[i] = A_u;
        sum.h[j] += static_cast<double>(basis_[j][i].dot(r_[i]));
        for (int k = 0; k < BASIS_SIZE; ++k) sum.G(j, k) += static_cast<double>(A_u.dot(basis_[k][i]));
      }
    });
  });
  combinations_.assign(groups_, BasisProducts());
  for (int a = 0; a < aggregates_.count(); ++a) {
    combinations_[group_of_[a]].G += products_[a].G;
    combinations_[group_of_[a]].h += products_[a].h;
  }
  for (BasisProducts& sum : combinations_) sum.h = bestCombination(sum.G, sum.h);
  parallelFor(aggregates_.count(), threads, [&](int a) {
    const Eigen::Matrix<float, BASIS_SIZE, 1> c = combinations_[group_of_[a]].h.cast<float>();
    forEachRow(a, [&](int i) {
      y_[i].setZero();
      for (int j = 0; j < BASIS_SIZE; ++j) {
        y_[i] += c[j] * basis_[j][i];
        r_[i] -= c[j] * (*A_basis[j])[i];
      }
    });
  });
}

/// Adds to y_ what solves Â y = r_, until every piece's ratio is below `target`; r_ becomes the residual of the float
/// matrix.
int IterativeSolver::iterate(double target) {
  const int rows = pattern_.rows(), threads = assembly_->threads();
  std::fill(p_.begin(), p_.end(), Vec4f::Zero());
  parallelFor(aggregates_.count(), threads, [&](int a) { coarse_.restrictAggregate(a, r_); });
  double rz = 0;
  for (int iteration = 0; iteration < MAX_ITERATIONS; ++iteration) {
    const double next_rz = precondition();
    const float beta = iteration > 0 ? static_cast<float>(next_rz / rz) : 0;
    rz = next_rz;
    if (!(rz > 0)) return iteration;
    parallelFor(rows, threads, [&](int i) { p_[i] = z_[i] + beta * p_[i]; });
    if (coupled_.count() > 0) stretchSprings(p_);
    const double pAp = sumOverRows(rows, threads, &terms_, [&](int i) {
      Vec4f Ap = multiplyRow(pattern_, blocks_, i, p_);
      if (coupled_.count() > 0) Ap += coupled_.multiplyRow(i);
      Ap_[i] = Ap;
      return static_cast<double>(p_[i].dot(Ap));
    });
    if (!(pAp > 0)) return iteration;
    // The norm of all is cheap, but only that of the worst piece counts.
    if (update(rz / pAp) <= target && norms_.worstRatio(r_) <= target) return iteration + 1;
  }
  return MAX_ITERATIONS;
}

/// z = (block Jacobi + coarse space) r; returns r·z.
double IterativeSolver::precondition() {
  coarse_.solve();
  return sumOverRows(pattern_.rows(), assembly_->threads(), &terms_, [&](int i) {
    const Vec4f& r = r_[i];
    const auto& inverse = inverse_diagonal_[i];
    z_[i] = inverse.col(0) * r[0] + inverse.col(1) * r[1] + inverse.col(2) * r[2] + coarse_.prolong(i);
    return static_cast<double>(r.dot(z_[i]));
  });
}

/// One step along p_: y_, r_ and the coarse level's right-hand side; returns ‖r‖.
double IterativeSolver::update(double step) {
  const float alpha = static_cast<float>(step);
  return std::sqrt(parallelSum(aggregates_.count(), assembly_->threads(), &terms_, [&](int a) {
    double sum = 0;
    for (int i : aggregates_.rows[a]) {
      y_[i] += alpha * p_[i];
      r_[i] -= alpha * Ap_[i];
      sum += static_cast<double>(r_[i].squaredNorm());
    }
    coarse_.restrictAggregate(a, r_);
    return sum;
  }));
}

}  // namespace incision
