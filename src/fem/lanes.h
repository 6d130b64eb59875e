#pragma once

#include <algorithm>

#include "incision/fem/rotation.h"

namespace incision {

/// LANES numbers that are reckoned with together, and matrices of them. What comes out in a lane depends on that lane
/// alone, so it does not matter what is beside it.
using Lanes = double __attribute__((vector_size(LANES * sizeof(double))));
using LaneMatrix = Lanes[3][3];

/// Takes lane l from matrices(l).
template <typename Matrices>
void load(const Matrices& matrices, LaneMatrix& lanes) {
  for (int l = 0; l < LANES; ++l) {
    const Mat3& matrix = matrices(l);
    for (int j = 0; j < 3; ++j)
      for (int i = 0; i < 3; ++i) lanes[i][j][l] = matrix(i, j);
  }
}

/// Puts lane l into matrices(l).
template <typename Matrices>
void store(const LaneMatrix& lanes, const Matrices& matrices) {
  for (int l = 0; l < LANES; ++l) {
    Mat3& matrix = matrices(l);
    for (int j = 0; j < 3; ++j)
      for (int i = 0; i < 3; ++i) matrix(i, j) = lanes[i][j][l];
  }
}

/// C = A B.
inline void multiply(const LaneMatrix& A, const LaneMatrix& B, LaneMatrix& C) {
  for (int i = 0; i < 3; ++i)
    for (int j = 0; j < 3; ++j) C[i][j] = A[i][0] * B[0][j] + A[i][1] * B[1][j] + A[i][2] * B[2][j];
}

/// C = Aᵀ B.
inline void multiplyTransposed(const LaneMatrix& A, const LaneMatrix& B, LaneMatrix& C) {
  for (int i = 0; i < 3; ++i)
    for (int j = 0; j < 3; ++j) C[i][j] = A[0][i] * B[0][j] + A[1][i] * B[1][j] + A[2][i] * B[2][j];
}

/// C = A Bᵀ.
inline void multiplyByTransposed(const LaneMatrix& A, const LaneMatrix& B, LaneMatrix& C) {
  for (int i = 0; i < 3; ++i)
    for (int j = 0; j < 3; ++j) C[i][j] = A[i][0] * B[j][0] + A[i][1] * B[j][1] + A[i][2] * B[j][2];
}

}  // namespace incision
