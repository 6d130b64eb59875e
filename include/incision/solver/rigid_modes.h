#pragma once

#include "incision/base/vec.h"

namespace incision {

/// Rigid modes of some copies: three shifts and three turns.
inline constexpr int MODES = 6;

/// [a]×.
inline Mat3 crossMatrix(const Vec3& a) {
  return (Mat3() << 0, -a.z(), a.y(), a.z(), 0, -a.x(), -a.y(), a.x(), 0).finished();
}

/// What a spring sees of these modes: H = [a 1 | −[b]×].
struct ModesSeen {
  double a;
  Vec3 b;
};

/// What the stiffness K of a spring adds to the block between the modes in a row and those in a column: H_rowᵀ K
/// H_column.
inline void addModes(const Mat3& K, const ModesSeen& row, const ModesSeen& column,
                     Eigen::Matrix<double, MODES, MODES>* block) {
  const Mat3 shift = row.a * K, turn = crossMatrix(row.b) * K, arms = crossMatrix(column.b);
  block->topLeftCorner<3, 3>() += column.a * shift;
  block->topRightCorner<3, 3>() -= shift * arms;
  block->bottomLeftCorner<3, 3>() += column.a * turn;
  block->bottomRightCorner<3, 3>() -= turn * arms;
}

}  // namespace incision
