#pragma once

#include <vector>

#include "incision/fem/assembly.h"

namespace incision {

/// Which copies are free, in the order in which the system numbers them, and which pairs of them a part couples.
struct BlockPattern {
  std::vector<int> copies;     ///< copy of each row
  std::vector<int> row_of;     ///< row of each copy, −1 when held
  std::vector<int> row_start;  ///< blocks row_start[r] … row_start[r + 1] − 1 lie in row r
  std::vector<int> column;     ///< of each block, ascending in a row
  std::vector<int> mirror;     ///< the block on the other side of the diagonal; itself on the diagonal
  std::vector<int> diagonal;   ///< the block of each row on the diagonal

  /// What adds to block k where column ≥ row (the others mirror it): terms[term_start[k]] … terms[term_start[k + 1] −
  /// 1], each 16 part + 4 I + J with I the row's corner and J the column's.
  std::vector<int> term_start, terms;

  int rows() const { return static_cast<int>(copies.size()); }
};

/// Rows are the copies listed in `order`, which leaves out the held ones. Arrays keep their memory from call to call.
void findPattern(const Assembly& assembly, const std::vector<int>& order, BlockPattern* pattern);

/// The factors in A = mass M + stiffness K.
struct SystemFactors {
  double mass, stiffness;
};

/// trace(A_cc)/3 for every copy. Turning parts does not change it, so it holds until the topology changes.
std::vector<double> diagonalScale(const Assembly& assembly, const SystemFactors& factors);

/// Entries of a block, column by column, each column padded to four for vector registers.
inline constexpr int BLOCK_SIZE = 12;

/// Gathers A = mass M + stiffness K block by block, so threads never write to the same place. T is float or double.
template <typename T>
class BlockAssembler {
 public:
  /// Writes BLOCK_SIZE values for each block of the pattern: s_row s_column A_block, with `scale` giving s of each row.
  void assemble(const Assembly& assembly, const BlockPattern& pattern, const SystemFactors& factors,
                const std::vector<double>& scale, std::vector<T>* blocks);

 private:
  std::vector<Eigen::Matrix<T, 3, 4>> gradients_;  // R_p b_I of every part
  std::vector<double> weights_;                    // stiffness V_p of every part
};

}  // namespace incision
