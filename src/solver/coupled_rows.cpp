#include "incision/solver/coupled_rows.h"

#include <numeric>

namespace incision {

void CoupledRows::set(const std::vector<Coupling>& couplings, double time_step, const BlockPattern& pattern,
                      const std::vector<double>& scale) {
  ends_.clear();
  stiffness_.clear();
  start_.assign(1, 0);
  for (const Coupling& coupling : couplings) {
    for (int i = 0; i < coupling.count; ++i)
      if (const int row = pattern.row_of[coupling.copies[i]]; row >= 0)
        ends_.push_back({row, static_cast<float>(coupling.weights[i] * scale[row])});
    if (static_cast<int>(ends_.size()) == start_.back()) continue;
    start_.push_back(static_cast<int>(ends_.size()));
    stiffness_.emplace_back(Eigen::Matrix<float, 4, 3>::Zero());
    stiffness_.back().topRows<3>() = (time_step * time_step * coupling.stiffness).cast<float>();
  }
  force_.resize(stiffness_.size());
  findHolds(pattern.rows());
}

/// Sorts the ends by row; those of one row stay in the order of their couplings.
void CoupledRows::findHolds(int rows) {
  row_start_.assign(rows + 1, 0);
  for (const End& end : ends_) ++row_start_[end.row + 1];
  rows_.clear();
  for (int row = 0; row < rows; ++row)
    if (row_start_[row + 1] > 0) rows_.push_back(row);
  std::partial_sum(row_start_.begin(), row_start_.end(), row_start_.begin());
  held_.resize(ends_.size());
  for (int c = 0; c < count(); ++c)
    for (int k = start_[c]; k < start_[c + 1]; ++k) held_[row_start_[ends_[k].row]++] = {c, ends_[k].g};
  // Each start has moved on to the next row's.
  for (int row = rows; row > 0; --row) row_start_[row] = row_start_[row - 1];
  row_start_[0] = 0;
}

Mat3 CoupledRows::diagonal(int k) const {
  Mat3 sum = Mat3::Zero();
  for (int h = row_start_[rows_[k]]; h < row_start_[rows_[k] + 1]; ++h) {
    const double g = held_[h].g;
    sum += g * g * stiffness_[held_[h].coupling].topRows<3>().cast<double>();
  }
  return sum;
}

void CoupledRows::stretch(int c, const std::vector<Vec4f>& p) {
  Vec4f y = Vec4f::Zero();
  for (int k = start_[c]; k < start_[c + 1]; ++k) y += ends_[k].g * p[ends_[k].row];
  const auto& K = stiffness_[c];
  force_[c] = K.col(0) * y[0] + K.col(1) * y[1] + K.col(2) * y[2];
}

}  // namespace incision
