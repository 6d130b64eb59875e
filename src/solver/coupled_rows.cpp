#include "incision/solver/coupled_rows.h"

namespace incision {

void CoupledRows::set(const std::vector<Spring>& springs, double time_step, const BlockPattern& pattern,
                      const std::vector<double>& scale) {
  ends_.clear();
  stiffness_.clear();
  for (const Spring& spring : springs) {
    if (!spring.isStiff()) continue;
    for (int i = 0; i < spring.count; ++i)
      if (const int row = pattern.row_of[spring.copies[i]]; row >= 0)
        ends_.append({row, static_cast<float>(spring.weights[i] * scale[row])});
    if (ends_.unfinished().size() == 0) continue;
    ends_.finish();
    stiffness_.emplace_back(Eigen::Matrix<float, 4, 3>::Zero());
    stiffness_.back().topRows<3>() = (time_step * time_step * spring.stiffness).cast<float>();
  }
  force_.resize(stiffness_.size());
  findShares(pattern.rows());
}

/// Sorts the ends by row; those of one row stay in the order of their springs.
void CoupledRows::findShares(int rows) {
  shares_.sort(rows, [&](const auto& add) {
    for (int c = 0; c < count(); ++c)
      for (const End& end : ends_[c]) add(end.row, Share{c, end.g});
  });
  rows_.clear();
  for (int row = 0; row < rows; ++row)
    if (shares_[row].size() > 0) rows_.push_back(row);
}

Mat3 CoupledRows::diagonal(int k) const {
  Mat3 sum = Mat3::Zero();
  for (const Share& share : shares_[rows_[k]]) {
    const double g = share.g;
    sum += g * g * stiffness_[share.spring].topRows<3>().cast<double>();
  }
  return sum;
}

void CoupledRows::stretch(int c, const std::vector<Vec4f>& p) {
  Vec4f y = Vec4f::Zero();
  for (const End& end : ends_[c]) y += end.g * p[end.row];
  const auto& K = stiffness_[c];
  force_[c] = K.col(0) * y[0] + K.col(1) * y[1] + K.col(2) * y[2];
}

}  // namespace incision
