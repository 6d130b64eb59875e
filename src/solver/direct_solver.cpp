#include "incision/solver/direct_solver.h"

#include <algorithm>
#include <cmath>

#include "incision/base/sort_once.h"

namespace incision {
namespace {

/// Factorisations after which blocks that springs have left are dropped: contacts that only bounce are back by then.
constexpr int PATIENCE = 50;

/// Calls f(row, column, w_row w_column, K) for the blocks row ≤ column of every spring.
template <typename Function>
void forEachBlock(const std::vector<Spring>& springs, const std::vector<int>& row_of, const Function& f) {
  for (const Spring& spring : springs) {
    if (!spring.isStiff()) continue;
    for (int i = 0; i < spring.count; ++i)
      for (int j = 0; j < spring.count; ++j) {
        const int row = row_of[spring.copies[i]], column = row_of[spring.copies[j]];
        if (row >= 0 && row <= column) f(row, column, spring.weights[i] * spring.weights[j], spring.stiffness);
      }
  }
}

}  // namespace

void DirectSolver::systemChanged(const Assembly& assembly, const SystemChange& change, const SystemFactors& factors) {
  assembly_ = &assembly;
  factors_ = factors;
  std::vector<int> free_copies;
  for (int c = 0; c < assembly.mesh().numCopies(); ++c) {
    if (!change.left_out[c]) free_copies.push_back(c);
  }
  findPattern(assembly, free_copies, &pattern_);
  ones_.assign(free_copies.size(), 1);
  extra_.clear();
  idle_ = 0;
  analyse();
}

void DirectSolver::keep(SolverMemory* memory) const {
  memory->blocks = extra_;
  memory->idle = idle_;
}

/// Blocks that are no extra ones of this matrix are not taken over: then last digits may differ.
void DirectSolver::recall(const SolverMemory& memory) {
  idle_ = memory.idle;
  if (extra_ == memory.blocks) return;
  for (const auto& [row, column] : memory.blocks) {
    if (row >= pattern_.rows() || column >= pattern_.rows() || column <= row) return;
    const auto begin = pattern_.column.begin();
    if (std::binary_search(begin + pattern_.row_start[row], begin + pattern_.row_start[row + 1], column)) return;
  }
  extra_ = memory.blocks;
  analyse();
}

/// Finds the lower triangle of the pattern and the extra blocks, and an order to eliminate in.
void DirectSolver::analyse() {
  LowerTriangle lower;
  lower.column_start.push_back(0);
  source_.clear();
  // The matrix is symmetric: row r of blocks read from its diagonal on is column r of the lower triangle.
  std::vector<std::pair<int, int>> blocks;  // column and block, of one row from its diagonal on
  for (int r = 0, extra = 0; r < pattern_.rows(); ++r) {
    blocks.clear();
    for (int k = pattern_.diagonal[r]; k < pattern_.row_start[r + 1]; ++k) blocks.emplace_back(pattern_.column[k], k);
    for (; extra < static_cast<int>(extra_.size()) && extra_[extra].first == r; ++extra)
      blocks.emplace_back(extra_[extra].second, pattern_.row_start.back() + extra);
    std::sort(blocks.begin(), blocks.end());
    for (int j = 0; j < 3; ++j) {
      for (const auto& [column, block] : blocks)
        for (int i = column == r ? j : 0; i < 3; ++i) {
          lower.row.push_back(3 * column + i);
          source_.push_back(BLOCK_SIZE * block + 3 * i + j);
        }
      lower.column_start.push_back(static_cast<int>(lower.row.size()));
    }
  }
  values_.resize(source_.size());
  if (pattern_.rows() > 0) cholesky_.analyse(lower, 3);
}

void DirectSolver::matrixChanged(const std::vector<Vec3>&) {
  if (pattern_.rows() > 0) assembler_.assemble(*assembly_, pattern_, factors_, ones_, &blocks_);
}

bool DirectSolver::springsChanged(const std::vector<Spring>& springs, double time_step) {
  if (pattern_.rows() == 0) return true;
  if (springs.empty() && extra_.empty()) return factorise(blocks_);
  findBlocks(springs);
  coupled_blocks_ = blocks_;
  coupled_blocks_.resize(BLOCK_SIZE * static_cast<std::size_t>(pattern_.row_start.back()));
  coupled_blocks_.resize(BLOCK_SIZE * (pattern_.row_start.back() + extra_.size()), 0);
  forEachBlock(springs, pattern_.row_of, [&](int row, int column, double weight, const Mat3& K) {
    Eigen::Map<Mat3>(&coupled_blocks_[static_cast<std::size_t>(BLOCK_SIZE) * blockAt(row, column)]) +=
        time_step * time_step * weight * K;
  });
  return factorise(coupled_blocks_);
}

bool DirectSolver::factorise(const std::vector<double>& blocks) {
  for (std::size_t k = 0; k < source_.size(); ++k) values_[k] = blocks[source_[k]];
  return cholesky_.factorise(values_);
}

/// The block in a row from its diagonal on, or −1.
int DirectSolver::blockAt(int row, int column) const {
  const auto begin = pattern_.column.begin() + pattern_.diagonal[row];
  const auto end = pattern_.column.begin() + pattern_.row_start[row + 1];
  const auto at = std::lower_bound(begin, end, column);
  if (at != end && *at == column) return static_cast<int>(at - pattern_.column.begin());
  const auto extra = std::lower_bound(extra_.begin(), extra_.end(), std::make_pair(row, column));
  if (extra == extra_.end() || *extra != std::make_pair(row, column)) return -1;
  return pattern_.row_start.back() + static_cast<int>(extra - extra_.begin());
}

/// Makes room for the springs' blocks. They stay, as contacts come and go and each new one costs an analysis; but
/// what slides leaves a trail of them behind, which would fill the factor.
void DirectSolver::findBlocks(const std::vector<Spring>& springs) {
  const int blocks = pattern_.row_start.back();
  std::vector<std::pair<int, int>> missing;
  used_.assign(extra_.size(), 0);
  forEachBlock(springs, pattern_.row_of, [&](int row, int column, double, const Mat3&) {
    const int block = blockAt(row, column);
    if (block < 0) missing.emplace_back(row, column);
    if (block >= blocks) used_[block - blocks] = 1;
  });
  const auto in_use = static_cast<std::size_t>(std::count(used_.begin(), used_.end(), 1));
  idle_ = extra_.size() > 2 * in_use ? idle_ + 1 : 0;
  if (missing.empty() && idle_ < PATIENCE) return;
  if (idle_ > 0) {
    std::size_t kept = 0;
    for (std::size_t k = 0; k < extra_.size(); ++k)
      if (used_[k]) extra_[kept++] = extra_[k];
    extra_.resize(kept);
    idle_ = 0;
  }
  extra_.insert(extra_.end(), missing.begin(), missing.end());
  sortOnce(&extra_);
  analyse();
}

int DirectSolver::correct(const std::vector<Vec3>& r, const SolveDemand& /*demand*/, const Basis* /*basis*/,
                          std::vector<Vec3>* d, std::vector<Vec3>* left) {
  if (pattern_.rows() == 0) return 0;
  b_.resize(3 * pattern_.rows());
  for (int row = 0; row < pattern_.rows(); ++row)
    for (int i = 0; i < 3; ++i) b_[3 * row + i] = r[pattern_.copies[row]][i];
  cholesky_.solve(b_, &solution_);
  for (int row = 0; row < pattern_.rows(); ++row) {
    for (int i = 0; i < 3; ++i) (*d)[pattern_.copies[row]][i] = solution_[3 * row + i];
    (*left)[pattern_.copies[row]].setZero();
  }
  return 0;
}

}  // namespace incision
