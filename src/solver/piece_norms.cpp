#include "incision/solver/piece_norms.h"

#include <algorithm>
#include <cmath>

namespace incision {

void PieceNorms::systemChanged(const Assembly& assembly, const std::vector<int>& rows, const std::vector<int>& piece,
                               const std::vector<double>& scale) {
  rows_ = rows;
  piece_.clear();
  squared_scale_.clear();
  mass_.assign(piece.empty() ? 0 : 1 + *std::max_element(piece.begin(), piece.end()), 0);
  for (std::size_t i = 0; i < rows.size(); ++i) {
    piece_.push_back(piece[rows[i]]);
    squared_scale_.push_back(scale[i] * scale[i]);
    mass_[piece_.back()] += assembly.masses()[rows[i]];
  }
}

void PieceNorms::setRightHandSide(const std::vector<Vec3>& b, const std::vector<double>& rounding, double tolerance) {
  measure_.assign(mass_.size(), 0);
  sum_.assign(mass_.size(), 0);  // here: of the rounding
  for (std::size_t i = 0; i < rows_.size(); ++i) {
    const int copy = rows_[i];
    measure_[piece_[i]] += squared_scale_[i] * b[copy].squaredNorm();
    sum_[piece_[i]] += squared_scale_[i] * rounding[copy] * rounding[copy];
  }
  double whole = 0, mass = 0;
  for (std::size_t s = 0; s < mass_.size(); ++s) {
    whole += measure_[s];
    mass += mass_[s];
  }
  total_ = 0;
  for (std::size_t s = 0; s < mass_.size(); ++s) {
    measure_[s] = std::max({measure_[s], mass_[s] / mass * whole, sum_[s] / (tolerance * tolerance)});
    total_ += measure_[s];
  }
  total_ = std::sqrt(total_);
}

double PieceNorms::worstRatio(const std::vector<Vec3>& r) {
  sum_.assign(mass_.size(), 0);
  for (std::size_t i = 0; i < rows_.size(); ++i) sum_[piece_[i]] += squared_scale_[i] * r[rows_[i]].squaredNorm();
  return worstSum(1);
}

double PieceNorms::worstRatio(const std::vector<Vec4f>& r) {
  sum_.assign(mass_.size(), 0);
  for (std::size_t i = 0; i < rows_.size(); ++i) sum_[piece_[i]] += r[i].squaredNorm();
  return worstSum(total_ * total_);
}

double PieceNorms::worstSum(double unit) const {
  double worst = 0;
  for (std::size_t s = 0; s < mass_.size(); ++s) {
    if (unit * sum_[s] <= worst * measure_[s]) continue;
    worst = unit * sum_[s] / measure_[s];
    if (!std::isfinite(worst)) break;
  }
  return std::sqrt(worst);
}

}  // namespace incision
