#include "incision/solver/iterative_solver.h"

#include <Eigen/LU>
#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

#include "incision/base/parallel.h"

namespace incision {
namespace {

/// Iterations of one run of conjugate gradients. Scenes take 20 to 150; more means that float has lost the direction
/// and a fresh residual does better.
constexpr int MAX_ITERATIONS = 400;

/// What one run may gain at most: float vectors know no more.
constexpr double MIN_GAIN = 1e-5;

/// A run aims below the limit by this much, since the float matrix is not quite A.
constexpr double MARGIN = 0.7;

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
  coupled_ = CoupledRows();
  inverse_diagonal_.resize(rows);
  for (auto* v : {&y_, &r_, &z_, &p_, &Ap_}) v->assign(rows, Vec4f::Zero());
  basis_.fill(y_);
  products_.resize(aggregates_.count());
  piece_of_.clear();
  for (int a = 0; a < aggregates_.count(); ++a)
    piece_of_.push_back(change.piece[pattern_.copies[aggregates_.rows[a][0]]]);
  pieces_ = change.piece.empty() ? 0 : 1 + *std::max_element(change.piece.begin(), change.piece.end());
  findGroups();
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
  findGroups();
  return true;
}

/// Pieces between which springs act make a group. No aggregate spans two pieces.
void IterativeSolver::findGroups() {
  piece_sets_.reset(pieces_);
  for (int c = 0; c < coupled_.count(); ++c) {
    const Span<const CoupledRows::End> ends = coupled_.ends()[c];
    for (const CoupledRows::End& end : ends)
      piece_sets_.join(piece_of_[aggregates_.of[ends[0].row]], piece_of_[aggregates_.of[end.row]]);
  }
  group_of_.resize(piece_of_.size());
  for (std::size_t a = 0; a < piece_of_.size(); ++a) group_of_[a] = piece_sets_.lowest(piece_of_[a]);
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

int IterativeSolver::correct(const std::vector<Vec3>& r, const SolveDemand& demand, const Basis* basis,
                             std::vector<Vec3>* d, std::vector<Vec3>* left) {
  if (pattern_.rows() == 0) return 0;
  const double unit = scaleResidual(r);
  if (!(unit > 0)) return 0;
  std::fill(y_.begin(), y_.end(), Vec4f::Zero());
  findActive(demand.limit, unit);
  if (basis) guess(*basis);
  const int iterations = iterate(demand.limit, unit, std::min(demand.most, MAX_ITERATIONS));
  if (demand.balanced && coupled_.count() > 0) balance();
  parallelFor(pattern_.rows(), assembly_->threads(), [&](int i) {
    (*d)[pattern_.copies[i]] = unit * scale_[i] * y_[i].head<3>().cast<double>();
    (*left)[pattern_.copies[i]] = unit / scale_[i] * r_[i].head<3>().cast<double>();
  });
  return iterations;
}

/// Takes r into r_, scaled to the length 1, and returns what it had.
double IterativeSolver::scaleResidual(const std::vector<Vec3>& r) {
  const int threads = assembly_->threads();
  const double square = parallelSum(aggregates_.count(), threads, &terms_, [&](int a) {
    double sum = 0;
    for (int i : aggregates_.rows[a]) sum += scale_[i] * scale_[i] * r[pattern_.copies[i]].squaredNorm();
    return sum;
  });
  const double unit = std::sqrt(square);
  if (!(unit > 0)) return 0;
  parallelFor(pattern_.rows(), threads,
              [&](int i) { r_[i].head<3>() = (scale_[i] / unit * r[pattern_.copies[i]]).cast<float>(); });
  return unit;
}

/// |r_|² of an aggregate.
double IterativeSolver::squareOf(int aggregate) const {
  double sum = 0;
  for (int i : aggregates_.rows[aggregate]) sum += static_cast<double>(r_[i].squaredNorm());
  return sum;
}

/// Finds the groups that have a piece above its limit.
void IterativeSolver::findActive(const std::vector<double>& limit, double unit) {
  piece_sum_.assign(static_cast<std::size_t>(pieces_), 0);
  groups_.assign(static_cast<std::size_t>(pieces_), Group());
  for (int a = 0; a < aggregates_.count(); ++a) piece_sum_[piece_of_[a]] += squareOf(a);
  for (std::size_t s = 0; s < piece_sum_.size(); ++s)
    if (unit * unit * piece_sum_[s] > limit[s]) groups_[piece_sets_.lowest(static_cast<int>(s))].goes_on = true;
  active_.clear();
  for (int a = 0; a < aggregates_.count(); ++a)
    if (groups_[group_of_[a]].goes_on) active_.push_back(a);
}

/// Takes for y_ the best sum of the basis in each group, since groups move by themselves, and for r_ what it leaves of
/// the right-hand side r_.
void IterativeSolver::guess(const Basis& basis) {
  const int threads = assembly_->threads(), active = static_cast<int>(active_.size());
  const std::array<std::vector<Vec4f>*, BASIS_SIZE> A_basis = {&z_, &p_, &Ap_};  // not in use yet
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
  parallelFor(active, threads, [&](int k) {
    const int a = active_[k];
    BasisProducts& sum = products_[a];
    sum = BasisProducts();
    for (int i : aggregates_.rows[a])
      for (int j = 0; j < BASIS_SIZE; ++j) {
        Vec4f A_u = multiplyRow(pattern_, blocks_, i, basis_[j]);
        if (coupled_.count() > 0) A_u += (*A_basis[j])[i];
        (*A_basis[j])[i] = A_u;
        sum.h[j] += static_cast<double>(basis_[j][i].dot(r_[i]));
        for (int l = 0; l < BASIS_SIZE; ++l) sum.G(j, l) += static_cast<double>(A_u.dot(basis_[l][i]));
      }
  });
  combinations_.assign(groups_.size(), BasisProducts());
  for (int a : active_) {
    combinations_[group_of_[a]].G += products_[a].G;
    combinations_[group_of_[a]].h += products_[a].h;
  }
  for (BasisProducts& sum : combinations_) sum.h = bestCombination(sum.G, sum.h);
  parallelFor(active, threads, [&](int k) {
    const int a = active_[k];
    const Eigen::Matrix<float, BASIS_SIZE, 1> c = combinations_[group_of_[a]].h.cast<float>();
    for (int i : aggregates_.rows[a])
      for (int j = 0; j < BASIS_SIZE; ++j) {
        y_[i] += c[j] * basis_[j][i];
        r_[i] -= c[j] * (*A_basis[j])[i];
      }
  });
}

/// Adds to y_ what solves Â y = r_, until every piece is below its limit, or `most` times; r_ becomes the residual of
/// the float matrix. The scalars are those of each group: it is as if each were iterated alone.
int IterativeSolver::iterate(const std::vector<double>& limit, double unit, int most) {
  for (int a : active_) terms_[a] = squareOf(a);
  sumPieces();
  for (std::size_t s = 0; s < limit.size(); ++s)
    groups_[piece_sets_.lowest(static_cast<int>(s))].least += MIN_GAIN * MIN_GAIN * piece_sum_[s];
  aims_.resize(limit.size());
  for (std::size_t s = 0; s < limit.size(); ++s)
    aims_[s] =
        std::max(MARGIN * MARGIN * limit[s] / (unit * unit), groups_[piece_sets_.lowest(static_cast<int>(s))].least);
  stopGroups();
  coarse_.clearResidual();
  for (int a : active_) coarse_.restrictAggregate(a, r_);
  for (int iteration = 0; iteration < most; ++iteration) {
    if (active_.empty()) return iteration;
    precondition();
    findDirections(iteration == 0);
    multiply();
    advance();
    stopGroups();
  }
  return most;
}

/// One step of the coarse level alone: by it no rigid motion of an aggregate is driven any more, nor of a piece.
void IterativeSolver::balance() {
  const int threads = assembly_->threads();
  active_.resize(static_cast<std::size_t>(aggregates_.count()));
  std::iota(active_.begin(), active_.end(), 0);
  parallelFor(aggregates_.count(), threads, [&](int a) { coarse_.restrictAggregate(a, r_); });
  coarse_.solve();
  parallelFor(pattern_.rows(), threads, [&](int i) { p_[i] = coarse_.prolong(i); });
  multiply();
  parallelFor(pattern_.rows(), threads, [&](int i) {
    y_[i] += p_[i];
    r_[i] -= Ap_[i];
  });
}

/// Adds the aggregates' terms up by group, and by piece.
void IterativeSolver::sumByGroup(double Group::*sum) {
  for (Group& group : groups_) group.*sum = 0;
  for (int a : active_) groups_[group_of_[a]].*sum += terms_[a];
}

/// z = (block Jacobi + coarse space) r, and r·z.
void IterativeSolver::precondition() {
  coarse_.solve();
  parallelFor(static_cast<int>(active_.size()), assembly_->threads(), [&](int k) {
    const int a = active_[k];
    double sum = 0;
    for (int i : aggregates_.rows[a]) {
      const Vec4f& r = r_[i];
      const auto& inverse = inverse_diagonal_[i];
      z_[i] = inverse.col(0) * r[0] + inverse.col(1) * r[1] + inverse.col(2) * r[2] + coarse_.prolong(i);
      sum += static_cast<double>(r.dot(z_[i]));
    }
    terms_[a] = sum;
  });
  sumByGroup(&Group::next_rz);
}

/// p = z + β p. A group whose r·z is not positive has come to where floats end.
void IterativeSolver::findDirections(bool first) {
  for (Group& group : groups_) {
    group.beta = first ? 0 : static_cast<float>(group.next_rz / group.rz);
    group.rz = group.next_rz;
    if (!(group.rz > 0)) group.goes_on = false;
  }
  parallelFor(static_cast<int>(active_.size()), assembly_->threads(), [&](int k) {
    const int a = active_[k];
    const float beta = groups_[group_of_[a]].beta;
    for (int i : aggregates_.rows[a]) p_[i] = first ? z_[i] : Vec4f(z_[i] + beta * p_[i]);
  });
}

/// Ap and p·Ap.
void IterativeSolver::multiply() {
  if (coupled_.count() > 0) stretchSprings(p_);
  parallelFor(static_cast<int>(active_.size()), assembly_->threads(), [&](int k) {
    const int a = active_[k];
    double sum = 0;
    for (int i : aggregates_.rows[a]) {
      Vec4f Ap = multiplyRow(pattern_, blocks_, i, p_);
      if (coupled_.count() > 0) Ap += coupled_.multiplyRow(i);
      Ap_[i] = Ap;
      sum += static_cast<double>(p_[i].dot(Ap));
    }
    terms_[a] = sum;
  });
  sumByGroup(&Group::pAp);
}

/// One step of each group along p: y_, r_ and the coarse level's right-hand side.
void IterativeSolver::advance() {
  for (Group& group : groups_) {
    if (!(group.pAp > 0)) group.goes_on = false;
    group.alpha = group.goes_on ? static_cast<float>(group.rz / group.pAp) : 0;
  }
  parallelFor(static_cast<int>(active_.size()), assembly_->threads(), [&](int k) {
    const int a = active_[k];
    const float alpha = groups_[group_of_[a]].alpha;
    double sum = 0;
    for (int i : aggregates_.rows[a]) {
      y_[i] += alpha * p_[i];
      r_[i] -= alpha * Ap_[i];
      sum += static_cast<double>(r_[i].squaredNorm());
    }
    terms_[a] = sum;
    coarse_.restrictAggregate(a, r_);
  });
  sumPieces();
}

/// Adds up |r|² of the pieces that go on.
void IterativeSolver::sumPieces() {
  for (int a : active_) piece_sum_[piece_of_[a]] = 0;
  for (int a : active_) piece_sum_[piece_of_[a]] += terms_[a];
}

/// Takes out the groups of which all pieces are where they should be, or which can go no further.
void IterativeSolver::stopGroups() {
  for (Group& group : groups_) group.is_above = false;
  for (int a : active_)
    if (!(piece_sum_[piece_of_[a]] <= aims_[piece_of_[a]])) groups_[group_of_[a]].is_above = true;
  const auto stopped = [&](int a) { return !groups_[group_of_[a]].goes_on || !groups_[group_of_[a]].is_above; };
  active_.erase(std::remove_if(active_.begin(), active_.end(), stopped), active_.end());
}

}  // namespace incision
