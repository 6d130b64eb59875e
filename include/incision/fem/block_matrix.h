#pragma once

#include <cstring>
#include <vector>

#include "incision/fem/block_pattern.h"
#include "incision/fem/tension.h"

namespace incision {

/// The factors in A = mass M + stiffness K, to which tension may add what it has found.
struct SystemFactors {
  double mass, stiffness;
  const Tension* tension = nullptr;
};

/// trace(A_cc)/3 of a copy, but for what tension adds. Turning parts does not change it, so it holds until the topology
/// changes.
double diagonalOf(const Assembly& assembly, const SystemFactors& factors, int copy);

/// Entries of a block, column by column.
inline constexpr int BLOCK_SIZE = 9;

/// Gathers A row by row, so threads never write to the same place. T is float or double.
template <typename T>
class BlockAssembler {
 public:
  /// Writes BLOCK_SIZE values for each block of the pattern: s_row s_column A_block, with `scale` giving s of each row;
  /// and one value more, so that the last column can be read as four.
  void assemble(const Assembly& assembly, const BlockPattern& pattern, const SystemFactors& factors,
                const std::vector<double>& scale, std::vector<T>* blocks);

 private:
  void findGradients(const Assembly& assembly, double stiffness, double least);
  void findPatchGradients(const Assembly& assembly, const BlockPattern& pattern, double stiffness,
                          const std::vector<double>& scale);

  std::vector<T> gradients_;            // √(stiffness V_p μ) R_p b_I of every part, twelve each
  std::vector<T> patch_gradients_;      // √(stiffness λ V_a) s ∇θ_a of every copy of every patch, three each
  std::vector<Vec3> volume_gradients_;  // V_a ∇θ_a of every copy of every patch
};

/// Three floats and padding, for vector registers.
using Vec4f = Eigen::Vector4f;

/// a × b of the first three; Eigen's own is not vectorised by every compiler.
inline Vec4f cross(const Vec4f& a, const Vec4f& b) {
  using Register = float __attribute__((vector_size(sizeof(Vec4f))));
  Register u, v;
  std::memcpy(&u, a.data(), sizeof u);
  std::memcpy(&v, b.data(), sizeof v);
  const Register turned = u * __builtin_shufflevector(v, v, 1, 2, 0, 3) - __builtin_shufflevector(u, u, 1, 2, 0, 3) * v;
  const Register product = __builtin_shufflevector(turned, turned, 1, 2, 0, 3);
  return Eigen::Map<const Vec4f>(reinterpret_cast<const float*>(&product));
}

/// Σ_c A_rc p_c of one row r; the fourth entries of `p` are padding, and zero in the result.
inline Vec4f multiplyRow(const BlockPattern& pattern, const std::vector<float>& blocks, int row,
                         const std::vector<Vec4f>& p) {
  using Column = Eigen::Map<const Vec4f>;  // a column and the first entry of the next
  const int *column = &pattern.column[pattern.row_start[row]],
            *end = &pattern.column[pattern.row_start[row + 1] - 1] + 1;
  const float* A = &blocks[static_cast<std::size_t>(BLOCK_SIZE) * pattern.row_start[row]];
  // Three sums, so that one addition need not wait for the last.
  Vec4f sum_0 = Vec4f::Zero(), sum_1 = Vec4f::Zero(), sum_2 = Vec4f::Zero();
  for (; column < end; ++column, A += BLOCK_SIZE) {
    const Vec4f& v = p[*column];
    sum_0 += Column(A) * v[0];
    sum_1 += Column(A + 3) * v[1];
    sum_2 += Column(A + 6) * v[2];
  }
  sum_0 += sum_1 + sum_2;
  sum_0[3] = 0;
  return sum_0;
}

}  // namespace incision
