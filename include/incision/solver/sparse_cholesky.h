#pragma once

#include <memory>
#include <vector>

namespace incision {

/// Lower triangle of a symmetric matrix by columns: rows ascending, the diagonal first.
struct LowerTriangle {
  std::vector<int> column_start, row;
  int size() const { return static_cast<int>(column_start.size()) - 1; }
};

/// Cholesky factorisation A = L Lᵀ: analysed once for a pattern, factorised for each set of values. The only class that
/// knows CHOLMOD, which it gives one thread: more make it slower at every size seen here.
class SparseCholesky {
 public:
  SparseCholesky();
  ~SparseCholesky();

  /// `block` > 1: unknowns come in blocks of that size with equal patterns, and the blocks are ordered, not the
  /// unknowns.
  void analyse(const LowerTriangle& pattern, int block);

  /// Returns false when the matrix is not positive definite. The values of the last time cost nothing.
  bool factorise(const std::vector<double>& values);

  void solve(const std::vector<double>& b, std::vector<double>* x);

 private:
  struct Cholmod;
  std::unique_ptr<Cholmod> cholmod_;
};

}  // namespace incision
