#include "incision/solver/coarse_space.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>

#include "incision/base/parallel.h"
#include "incision/base/sort_once.h"
#include "row_modes.h"

namespace incision {
namespace {

/// Added to the unit diagonal of the coarse matrix: the blocks it is summed from are floats, and an aggregate of a few
/// copies may not tell all rotations apart.
constexpr double REGULARISATION = 1e-7;

/// Where that does not make it positive definite more is added, up to here; then the level is left out.
constexpr double MAX_REGULARISATION = 1e-2;

}  // namespace

void CoarseSpace::topologyChanged(const BlockPattern& pattern, const Aggregates& aggregates,
                                  const std::vector<double>& scale) {
  pattern_ = &pattern;
  aggregates_ = &aggregates;
  extra_.clear();
  arm_.resize(pattern.rows());
  for (int i = 0; i < pattern.rows(); ++i) arm_[i].w() = static_cast<float>(1 / scale[i]);
  findBlocks();
  findUnknowns();
}

/// Blocks that are none of these aggregates are not taken over: then last digits may differ.
void CoarseSpace::recallSpringBlocks(const std::vector<std::pair<int, int>>& blocks) {
  if (extra_ == blocks) return;
  for (const auto& [row, column] : blocks)
    if (row >= aggregates_->count() || column >= row) return;
  extra_ = blocks;
  findBlocks();
  findUnknowns();
}

/// Blocks where the pattern has one between two aggregates, and the extra ones.
void CoarseSpace::findBlocks() {
  columns_.clear();
  auto extra = extra_.begin();
  std::vector<int> seen(aggregates_->count(), -1);
  for (int I = 0; I < aggregates_->count(); ++I) {
    for (int i : aggregates_->rows[I])
      for (int k = pattern_->row_start[i]; k < pattern_->row_start[i + 1]; ++k) {
        const int J = aggregates_->of[pattern_->column[k]];
        if (J > I || seen[J] == I) continue;
        seen[J] = I;
        columns_.append(J);
      }
    for (; extra != extra_.end() && extra->first == I; ++extra)
      if (seen[extra->second] != I) columns_.append(extra->second);
    std::sort(columns_.unfinished().begin(), columns_.unfinished().end());
    columns_.finish();
  }
  coarse_blocks_.resize(columns_.values().size());
}

/// Lists the entries of the lower triangle by columns: for each column block J the row blocks I ≥ J that hold it.
void CoarseSpace::findUnknowns() {
  const int count = aggregates_->count();
  Lists<std::pair<int, int>> in_column;  // row and number of each column's blocks
  in_column.sort(count, [&](const auto& add) {
    for (int I = 0; I < count; ++I)
      for (int k = columns_.start(I); k < columns_.start(I + 1); ++k) add(columns_.values()[k], std::pair(I, k));
  });
  LowerTriangle lower;
  lower.column_start.push_back(0);
  source_.clear();
  unknown_column_.clear();
  for (int J = 0; J < count; ++J)
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
  unit_.resize(MODES * count);
  right_.resize(MODES * count);
  solution_.assign(MODES * count, 0);
  motions_.assign(2 * count, Vec4f::Zero());
  cholesky_.analyse(lower, MODES);
}

void CoarseSpace::matrixChanged(const std::vector<Vec3>& x, const std::vector<float>& blocks, int threads) {
  parallelFor(aggregates_->count(), threads, [&](int a) { placeModes(a, x); });
  parallelFor(aggregates_->count(), threads, [&](int a) { projectAggregate(a, blocks); });
  coupled_ = false;
}

void CoarseSpace::springsChanged(const CoupledRows& springs, int threads) {
  if (coupled_) coarse_blocks_ = uncoupled_blocks_;
  coupled_ = springs.count() > 0;
  if (coupled_) {
    findEnds(springs);
    findPairs();
    uncoupled_blocks_ = coarse_blocks_;
    parallelFor(aggregates_->count(), threads, [&](int a) { addSprings(a, springs); });
  }
  usable_ = false;
  for (double extra = REGULARISATION; !usable_ && extra <= MAX_REGULARISATION; extra *= 100) usable_ = factorise(extra);
  if (!usable_) std::fill(motions_.begin(), motions_.end(), Vec4f::Zero());
}

void CoarseSpace::placeModes(int a, const std::vector<Vec3>& x) {
  const Span<const int> rows = aggregates_->rows[a];
  const auto position = [&](int row) -> const Vec3& { return x[pattern_->copies[row]]; };
  Vec3 centre = Vec3::Zero();
  for (int i : rows) centre += position(i) / static_cast<double>(rows.size());
  double radius = 0;
  for (int i : rows) radius = std::max(radius, (position(i) - centre).norm());
  for (int i : rows) {
    const Vec3 arm = radius > 0 ? Vec3((position(i) - centre) / radius) : Vec3::Zero();
    arm_[i].head<3>() = arm_[i].w() * arm.cast<float>();
  }
}

int CoarseSpace::blockAt(int I, int J) const {
  const Span<const int> columns = columns_[I];
  return columns_.start(I) + static_cast<int>(std::lower_bound(columns.begin(), columns.end(), J) - columns.begin());
}

/// Coarse blocks (I, J) = Σ_{i ∈ I, j ∈ J} Q_iᵀ A_ij Q_j of one row of aggregates.
void CoarseSpace::projectAggregate(int I, const std::vector<float>& blocks) {
  for (int c = columns_.start(I); c < columns_.start(I + 1); ++c) coarse_blocks_[c].setZero();
  for (int i : aggregates_->rows[I]) {
    // Columns of one aggregate mostly follow each other: A_ij Q_j is summed over such a run first.
    for (int k = pattern_->row_start[i]; k < pattern_->row_start[i + 1];) {
      const int J = aggregates_->of[pattern_->column[k]];
      RowModes sum;
      for (; k < pattern_->row_start[i + 1] && aggregates_->of[pattern_->column[k]] == J; ++k)
        if (J <= I) sum.add(&blocks[static_cast<std::size_t>(BLOCK_SIZE) * k], arm_[pattern_->column[k]]);
      if (J <= I) sum.addTo(arm_[i], coarse_blocks_[blockAt(I, J)].data());
    }
  }
}

void CoarseSpace::findEnds(const CoupledRows& springs) {
  ends_.clear();
  for (int c = 0; c < springs.count(); ++c) {
    for (const auto& [row, g] : springs.ends()[c]) {
      const int a = aggregates_->of[row];
      Span<CoarseEnd> ends = ends_.unfinished();
      int at = 0;
      while (at < ends.size() && ends[at].aggregate != a) ++at;
      if (at == ends.size()) ends_.append({a, c, {0, Vec3::Zero()}});
      CoarseEnd& end = ends_.unfinished()[at];
      end.seen.a += g * arm_[row].w();
      end.seen.b += g * arm_[row].head<3>().cast<double>();
    }
    ends_.finish();
  }
  ends_within_.sort(aggregates_->count(), [&](const auto& add) {
    for (std::size_t e = 0; e < ends_.values().size(); ++e) add(ends_.values()[e].aggregate, static_cast<int>(e));
  });
}

/// Makes room for the blocks that springs need beside the pattern's. They stay, as contacts come and go: each new one
/// costs an analysis.
void CoarseSpace::findPairs() {
  const std::size_t known = extra_.size();
  for (int c = 0; c < ends_.count(); ++c)
    for (const CoarseEnd& end : ends_[c])
      for (const CoarseEnd& other : ends_[c]) {
        const int I = end.aggregate, J = other.aggregate;
        if (J < I && !std::binary_search(columns_[I].begin(), columns_[I].end(), J)) extra_.emplace_back(I, J);
      }
  if (extra_.size() == known) return;
  sortOnce(&extra_);
  const Lists<int> columns = columns_;
  const std::vector<CoarseBlock> blocks = coarse_blocks_;
  findBlocks();
  for (CoarseBlock& block : coarse_blocks_) block.setZero();
  for (int I = 0; I < aggregates_->count(); ++I)
    for (int k = columns.start(I); k < columns.start(I + 1); ++k)
      coarse_blocks_[blockAt(I, columns.values()[k])] = blocks[k];
  findUnknowns();
}

/// Adds H_Iᵀ K H_J for every spring that acts on aggregate I, H = [a 1 | −[b]×] being what it sees of the modes.
void CoarseSpace::addSprings(int I, const CoupledRows& springs) {
  for (int e : ends_within_[I]) {
    const CoarseEnd& end = ends_.values()[e];
    const int c = end.spring;
    const Mat3 K = springs.stiffness(c).topRows<3>().cast<double>();
    for (const CoarseEnd& other : ends_[c])
      if (other.aggregate <= I) addModes(K, end.seen, other.seen, &coarse_blocks_[blockAt(I, other.aggregate)]);
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

void CoarseSpace::restrictAggregate(int aggregate, const std::vector<Vec4f>& r) {
  Vec4f force = Vec4f::Zero(), moment = Vec4f::Zero();
  for (int i : aggregates_->rows[aggregate]) {
    force += arm_[i].w() * r[i];
    moment += cross(arm_[i], r[i]);
  }
  for (int m = 0; m < 3; ++m) {
    right_[MODES * aggregate + m] = force[m] * unit_[MODES * aggregate + m];
    right_[MODES * aggregate + 3 + m] = moment[m] * unit_[MODES * aggregate + 3 + m];
  }
}

void CoarseSpace::solve() {
  if (!usable_) return;
  cholesky_.solve(right_, &solution_);
  for (std::size_t a = 0; a < motions_.size(); ++a)
    for (int m = 0; m < 3; ++m) motions_[a][m] = static_cast<float>(solution_[3 * a + m] * unit_[3 * a + m]);
}

}  // namespace incision
