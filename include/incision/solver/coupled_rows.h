#pragma once

#include <vector>

#include "incision/base/lists.h"
#include "incision/fem/block_matrix.h"
#include "incision/solver/spring.h"

namespace incision {

/// What springs add to the matrix of an iteration: Σ_c G_cᵀ K_c G_c, with G_c p = Σ_i g_i p_i over the rows i that a
/// spring acts on. It is never put into the pattern, since it changes from step to step.
class CoupledRows {
 public:
  /// One copy's share in a spring.
  struct End {
    int row;
    float g;  ///< weight × scale of the row
  };

  /// Takes over Δt² K of all springs that act on a row of the pattern. `scale` gives s of each row.
  void set(const std::vector<Spring>& springs, double time_step, const BlockPattern& pattern,
           const std::vector<double>& scale);

  int count() const { return static_cast<int>(stiffness_.size()); }
  /// The ends of each spring.
  const Lists<End>& ends() const { return ends_; }
  /// Δt² K_c, with a fourth row of zeros.
  const Eigen::Matrix<float, 4, 3>& stiffness(int c) const { return stiffness_[c]; }

  /// The rows that springs act on, ascending.
  const std::vector<int>& rows() const { return rows_; }
  /// The block they add to the diagonal in row rows()[k].
  Mat3 diagonal(int k) const;

  /// Keeps K_c G_c p of spring c, for multiplyRow.
  void stretch(int c, const std::vector<Vec4f>& p);
  /// What the springs add to the product in one row.
  Vec4f multiplyRow(int row) const {
    Vec4f sum = Vec4f::Zero();
    for (const Share& share : shares_[row]) sum += share.g * force_[share.spring];
    return sum;
  }

 private:
  /// One spring's share in a row.
  struct Share {
    int spring;
    float g;
  };
  void findShares(int rows);

  Lists<End> ends_;
  std::vector<Eigen::Matrix<float, 4, 3>> stiffness_;
  std::vector<Vec4f> force_;
  Lists<Share> shares_;  // in each row of the pattern
  std::vector<int> rows_;
};

}  // namespace incision
