#include "incision/solver/coarse_space.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>

#include "incision/fem/parallel.h"

namespace incision {
namespace {

constexpr int MODES = 6;

/// Added to the unit diagonal of the coarse matrix: the blocks it is summed from are floats, and an aggregate of a few
/// copies may not tell all rotations apart.
constexpr double REGULARISATION = 1e-7;

/// Where that does not make it positive definite more is added, up to here; then the level is left out.
constexpr double MAX_REGULARISATION = 1e-2;

Mat3 crossMatrix(const Vec3& a) { return (Mat3() << 0, -a.z(), a.y(), a.z(), 0, -a.x(), -a.y(), a.x(), 0).finished(); }

}  // namespace

void CoarseSpace::topologyChanged(const BlockPattern& pattern, const Aggregates& aggregates,
                                  const std::vector<double>& scale) {
  pattern_ = &pattern;
  aggregates_ = &aggregates;
  const int rows = pattern.rows();
  inverse_scale_.resize(rows);
  for (int i = 0; i < rows; ++i) inverse_scale_[i] = 1 / scale[i];
  aggregate_of_.resize(rows);
  for (int a = 0; a < aggregates.count(); ++a)
    std::fill(aggregate_of_.begin() + aggregates.start[a], aggregate_of_.begin() + aggregates.start[a + 1], a);
  arm_.resize(rows);

  block_start_.assign(1, 0);
  column_.clear();
  std::vector<int> seen(aggregates.count(), -1);
  for (int I = 0; I < aggregates.count(); ++I) {
    for (int i = aggregates.start[I]; i < aggregates.start[I + 1]; ++i)
      for (int k = pattern.row_start[i]; k < pattern.row_start[i + 1]; ++k) {
        const int J = aggregate_of_[pattern.column[k]];
        if (J > I || seen[J] == I) continue;
        seen[J] = I;
        column_.push_back(J);
      }
    std::sort(column_.begin() + block_start_.back(), column_.end());
    block_start_.push_back(static_cast<int>(column_.size()));
  }
  coarse_blocks_.resize(column_.size());

  // By columns of the lower triangle: for each column block J the row blocks I ≥ J that hold it.
  std::vector<std::vector<std::pair<int, int>>> in_column(aggregates.count());
  for (int I = 0; I < aggregates.count(); ++I)
    for (int k = block_start_[I]; k < block_start_[I + 1]; ++k) in_column[column_[k]].emplace_back(I, k);
  LowerTriangle lower;
  lower.column_start.push_back(0);
  source_.clear();
  unknown_column_.clear();
  for (int J = 0; J < aggregates.count(); ++J)
    for (int j = 0; j < MODES; ++j) {
      for (const auto& [I, k] : in_column[J])
        for (int i = I == J ? j : 0; i < MODES; ++i) {
          lower.row.push_back(MODES * I + i);
          unknown_column_.push_back(MODES * J + j);
          source_.push_back(MODES * MODES * k + MODES * j + i);
        }
      lower.column_start.push_back(static_cast<int>(lower.row.size()));
    }
  unknown_row_ = lower.row;
  values_.resize(source_.size());
  unit_.resize(MODES * aggregates.count());
  right_.resize(MODES * aggregates.count());
  solution_.assign(MODES * aggregates.count(), 0);
  cholesky_.analyse(lower, MODES);
}

void CoarseSpace::matrixChanged(const std::vector<Vec3>& x, const std::vector<float>& blocks, int threads) {
  parallelFor(aggregates_->count(), threads, [&](int a) {
    const int begin = aggregates_->start[a], end = aggregates_->start[a + 1];
    Vec3 centre = Vec3::Zero();
    for (int i = begin; i < end; ++i) centre += x[pattern_->copies[i]] / (end - begin);
    double radius = 0;
    for (int i = begin; i < end; ++i) {
      arm_[i] = x[pattern_->copies[i]] - centre;
      radius = std::max(radius, arm_[i].norm());
    }
    for (int i = begin; i < end && radius > 0; ++i) arm_[i] /= radius;
  });
  parallelFor(aggregates_->count(), threads, [&](int a) { projectAggregate(a, blocks); });
  usable_ = false;
  for (double extra = REGULARISATION; !usable_ && extra <= MAX_REGULARISATION; extra *= 100) usable_ = factorise(extra);
}

CoarseSpace::Modes CoarseSpace::modes(int row) const {
  Modes Q;
  Q.leftCols<3>() = inverse_scale_[row] * Mat3::Identity();
  Q.rightCols<3>() = -inverse_scale_[row] * crossMatrix(arm_[row]);
  return Q;
}

/// Coarse blocks (I, J) = Σ_{i ∈ I, j ∈ J} Q_iᵀ A_ij Q_j of one row of aggregates.
void CoarseSpace::projectAggregate(int I, const std::vector<float>& blocks) {
  for (int c = block_start_[I]; c < block_start_[I + 1]; ++c) coarse_blocks_[c].setZero();
  for (int i = aggregates_->start[I]; i < aggregates_->start[I + 1]; ++i) {
    const Modes Qi = modes(i);
    // Columns ascend, and so do their aggregates: each row adds to its coarse blocks one after the other.
    int c = block_start_[I];
    for (int k = pattern_->row_start[i]; k < pattern_->row_start[i + 1];) {
      const int J = aggregate_of_[pattern_->column[k]];
      if (J > I) break;
      Modes AQ = Modes::Zero();
      for (; k < pattern_->row_start[i + 1] && aggregate_of_[pattern_->column[k]] == J; ++k) {
        const int j = pattern_->column[k];
        const Mat3 A = Eigen::Map<const Eigen::Matrix<float, 4, 3>>(&blocks[static_cast<std::size_t>(BLOCK_SIZE) * k])
                           .topRows<3>()
                           .cast<double>() *
                       inverse_scale_[j];
        AQ.leftCols<3>() += A;
        AQ.rightCols<3>() -= A * crossMatrix(arm_[j]);
      }
      while (column_[c] != J) ++c;
      coarse_blocks_[c].noalias() += Qi.transpose() * AQ;
    }
  }
}

bool CoarseSpace::factorise(double regularisation) {
  const double* entries = coarse_blocks_.data()->data();
  for (std::size_t k = 0; k < source_.size(); ++k)
    if (unknown_row_[k] == unknown_column_[k]) {
      const double diagonal = entries[source_[k]];
      // A single copy has no rotations: its empty modes solve to nothing.
      unit_[unknown_row_[k]] = diagonal > 0 ? 1 / std::sqrt(diagonal) : 0;
    }
  for (std::size_t k = 0; k < source_.size(); ++k)
    values_[k] = unknown_row_[k] == unknown_column_[k]
                     ? 1 + regularisation
                     : entries[source_[k]] * unit_[unknown_row_[k]] * unit_[unknown_column_[k]];
  return cholesky_.factorise(values_);
}

void CoarseSpace::restrictAggregate(int aggregate, const std::vector<Vec3>& r) {
  Vec3 force = Vec3::Zero(), moment = Vec3::Zero();
  for (int i = aggregates_->start[aggregate]; i < aggregates_->start[aggregate + 1]; ++i) {
    const Vec3 f = inverse_scale_[i] * r[i];
    force += f;
    moment += arm_[i].cross(f);
  }
  for (int m = 0; m < 3; ++m) {
    right_[MODES * aggregate + m] = force[m] * unit_[MODES * aggregate + m];
    right_[MODES * aggregate + 3 + m] = moment[m] * unit_[MODES * aggregate + 3 + m];
  }
}

void CoarseSpace::solve() {
  if (!usable_) return;
  cholesky_.solve(right_, &solution_);
  for (std::size_t m = 0; m < solution_.size(); ++m) solution_[m] *= unit_[m];
}

Vec3 CoarseSpace::prolong(int aggregate, int row) const {
  if (!usable_) return Vec3::Zero();
  const double* e = &solution_[MODES * aggregate];
  const Vec3 shift(e[0], e[1], e[2]), turn(e[3], e[4], e[5]);
  return inverse_scale_[row] * (shift + turn.cross(arm_[row]));
}

}  // namespace incision
