#pragma once

#include <algorithm>
#include <utility>
#include <vector>

#include "incision/fem/block_matrix.h"
#include "incision/solver/aggregates.h"
#include "incision/solver/coupled_rows.h"
#include "incision/solver/rigid_modes.h"
#include "incision/solver/sparse_cholesky.h"

namespace incision {

/// The additive coarse level of the preconditioner: six rigid modes for each aggregate, in the scaled unknowns
/// √d Δv. In row i of an aggregate with centre c and radius ρ the modes are √d_i [1 | −[x_i − c]×/ρ].
class CoarseSpace {
 public:
  /// `scale` holds 1/√d of each row; pattern and aggregates must outlive this.
  void topologyChanged(const BlockPattern& pattern, const Aggregates& aggregates, const std::vector<double>& scale);

  /// The blocks that only springs have needed since then.
  const std::vector<std::pair<int, int>>& springBlocks() const { return extra_; }
  /// Puts them back. Between topologyChanged and matrixChanged.
  void recallSpringBlocks(const std::vector<std::pair<int, int>>& blocks);

  /// Takes the modes at the positions `x` [m] and the coarse matrix of the scaled float blocks.
  void matrixChanged(const std::vector<Vec3>& x, const std::vector<float>& blocks, int threads);

  /// Adds the springs to the coarse matrix, in place of those before, and factorises it.
  void springsChanged(const CoupledRows& springs, int threads);

  /// Makes the coarse right-hand side zero.
  void clearResidual() { std::fill(right_.begin(), right_.end(), 0); }
  /// Coarse right-hand side of one aggregate from the residual of its rows.
  void restrictAggregate(int aggregate, const std::vector<Vec4f>& r);
  void solve();
  /// What the coarse solution adds to a row: √d (shift + turn × (x_i − c)/ρ).
  Vec4f prolong(int row) const {
    const int a = aggregates_->of[row];
    return arm_[row].w() * motions_[2 * a] + cross(motions_[2 * a + 1], arm_[row]);
  }

 private:
  using CoarseBlock = Eigen::Matrix<double, MODES, MODES>;

  /// What a spring sees of an aggregate's modes: Σ_i g_i Q_i over its rows there.
  struct CoarseEnd {
    int aggregate, spring;
    ModesSeen seen;
  };

  void findBlocks();
  void findUnknowns();
  void placeModes(int aggregate, const std::vector<Vec3>& x);
  void projectAggregate(int aggregate, const std::vector<float>& blocks);
  int blockAt(int I, int J) const;
  void findEnds(const CoupledRows& springs);
  void findPairs();
  void addSprings(int aggregate, const CoupledRows& springs);
  bool factorise(double regularisation);

  const BlockPattern* pattern_ = nullptr;
  const Aggregates* aggregates_ = nullptr;
  std::vector<Vec4f> arm_;                  // √d (x_i − c)/ρ and √d of each row
  Lists<int> columns_;                      // J ≤ I of the coarse blocks (I, J) in each row I, ascending
  std::vector<std::pair<int, int>> extra_;  // those that only springs have needed, since the topology changed
  std::vector<CoarseBlock> coarse_blocks_, uncoupled_blocks_;
  bool coupled_ = false;     // coarse_blocks_ has springs in it
  Lists<CoarseEnd> ends_;    // of each spring
  Lists<int> ends_within_;   // which of ends_.values() are in each aggregate
  std::vector<int> source_;  // of each entry of the lower triangle, in coarse_blocks_
  std::vector<int> unknown_row_, unknown_column_;
  std::vector<double> unit_;  // 1/√diagonal of the coarse matrix
  std::vector<double> values_, right_, solution_;
  std::vector<Vec4f> motions_;  // shift and turn of each aggregate; zero where the level is left out
  SparseCholesky cholesky_;
  bool usable_ = false;
};

}  // namespace incision
