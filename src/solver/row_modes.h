#pragma once

#include <cstring>

#include "incision/fem/block_matrix.h"

namespace incision {

/// What some blocks A_ij of one row make of the rigid modes Q_j = [w 1 | −[b]×] of their columns: Σ A_ij Q_j, three
/// numbers of a column side by side. Their fourth has no meaning.
class RowModes {
 public:
  /// Adds A Q_j; `block` is read as ten numbers, `arm` is b and w.
  void add(const float* block, const Vec4f& arm) {
    Doubles A[3];
    for (int c = 0; c < 3; ++c) {
      Floats column;
      std::memcpy(&column, block + 3 * c, sizeof column);
      A[c] = __builtin_convertvector(column, Doubles);
    }
    const double x = arm.x(), y = arm.y(), z = arm.z(), w = arm.w();
    for (int c = 0; c < 3; ++c) modes_[c] += w * A[c];
    modes_[3] += y * A[2] - z * A[1];
    modes_[4] += z * A[0] - x * A[2];
    modes_[5] += x * A[1] - y * A[0];
  }

  /// Adds Q_iᵀ Σ A_ij Q_j to a coarse block of 6 × 6, column by column; `arm` is that of the row.
  void addTo(const Vec4f& arm, double* coarse) const {
    const double x = arm.x(), y = arm.y(), z = arm.z(), w = arm.w();
    for (int c = 0; c < 6; ++c, coarse += 6) {
      const Doubles& m = modes_[c];
      for (int i = 0; i < 3; ++i) coarse[i] += w * m[i];
      coarse[3] += y * m[2] - z * m[1];
      coarse[4] += z * m[0] - x * m[2];
      coarse[5] += x * m[1] - y * m[0];
    }
  }

 private:
  using Floats = float __attribute__((vector_size(16)));
  using Doubles = double __attribute__((vector_size(32)));

  Doubles modes_[6] = {};
};

}  // namespace incision
