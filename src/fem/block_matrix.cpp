#include "incision/fem/block_matrix.h"

#include <algorithm>
#include <numeric>

#include "incision/fem/parallel.h"

namespace incision {
namespace {

/// Calls f(column, term) for all that the parts round a row's copy couple it to, in the order of the parts.
template <typename Function>
void forEachTerm(const Assembly& assembly, const BlockPattern& pattern, int row, const Function& f) {
  const int copy = pattern.copies[row];
  for (int k = assembly.cornerStart()[copy]; k < assembly.cornerStart()[copy + 1]; ++k) {
    const Corner& corner = assembly.corners()[k];
    const Part& part = assembly.mesh().parts()[corner.part];
    for (int J = 0; J < 4; ++J)
      if (const int column = pattern.row_of[part.copies[J]]; column >= 0)
        f(column, 16 * corner.part + 4 * corner.node + J);
  }
}

/// A table over the rows, one for each thread, that lives on: it is filled anew, where it is read, for every row.
std::vector<int>& tableOfRows(int rows) {
  thread_local std::vector<int> table;
  if (static_cast<int>(table.size()) < rows) table.resize(rows, -1);
  return table;
}

/// Resizes without keeping the values, and with room for the next cuts: a body's largest arrays must not move for each.
template <typename T>
void resizeWithRoom(std::size_t size, std::vector<T>* values) {
  if (values->capacity() < size) {
    values->clear();
    values->reserve(size + size / 4);
  }
  values->resize(size);
}

/// Turns counts at [i + 1] into starts.
void accumulate(std::vector<int>* starts) { std::partial_sum(starts->begin(), starts->end(), starts->begin()); }

/// Finds row_start and column. Each row collects its columns where four for each of its corners have room.
void findColumns(const Assembly& assembly, BlockPattern* pattern) {
  thread_local std::vector<int> kept_room;
  std::vector<int>& room = kept_room;  // the caller's, for all threads
  resizeWithRoom(4 * assembly.corners().size(), &room);
  pattern->row_start.assign(pattern->rows() + 1, 0);
  const auto columnsOf = [&](int row) { return &room[4 * assembly.cornerStart()[pattern->copies[row]]]; };
  parallelFor(pattern->rows(), assembly.threads(), [&](int row) {
    std::vector<int>& seen_by = tableOfRows(pattern->rows());
    int *const columns = columnsOf(row), *end = columns;
    forEachTerm(assembly, *pattern, row, [&](int column, int) { seen_by[column] = -1; });
    forEachTerm(assembly, *pattern, row, [&](int column, int) {
      if (seen_by[column] == row) return;
      seen_by[column] = row;
      *end++ = column;
    });
    std::sort(columns, end);
    pattern->row_start[row + 1] = static_cast<int>(end - columns);
  });
  accumulate(&pattern->row_start);
  resizeWithRoom(pattern->row_start.back(), &pattern->column);
  parallelFor(pattern->rows(), assembly.threads(), [&](int row) {
    const int begin = pattern->row_start[row];
    std::copy_n(columnsOf(row), pattern->row_start[row + 1] - begin, pattern->column.begin() + begin);
  });
}

/// Finds the terms of the blocks from the diagonal on.
void findTerms(const Assembly& assembly, BlockPattern* pattern) {
  const auto forEachUpper = [&](int row, const auto& f) {
    std::vector<int>& block_of = tableOfRows(pattern->rows());
    for (int k = pattern->row_start[row]; k < pattern->row_start[row + 1]; ++k) block_of[pattern->column[k]] = k;
    forEachTerm(assembly, *pattern, row, [&](int column, int term) {
      if (column >= row) f(block_of[column], term);
    });
  };
  pattern->term_start.assign(pattern->column.size() + 1, 0);
  parallelFor(pattern->rows(), assembly.threads(),
              [&](int row) { forEachUpper(row, [&](int block, int) { ++pattern->term_start[block + 1]; }); });
  accumulate(&pattern->term_start);
  resizeWithRoom(pattern->term_start.back(), &pattern->terms);
  std::vector<int> next(pattern->term_start.begin(), pattern->term_start.end() - 1);
  parallelFor(pattern->rows(), assembly.threads(),
              [&](int row) { forEachUpper(row, [&](int block, int term) { pattern->terms[next[block]++] = term; }); });
}

void findMirrors(BlockPattern* pattern) {
  std::vector<int> next(pattern->row_start.begin(), pattern->row_start.end() - 1);
  pattern->mirror.resize(pattern->column.size());
  pattern->diagonal.resize(pattern->rows());
  // Rows are visited in order, so the blocks (column, row) of a column are met in the order they are stored.
  for (int row = 0; row < pattern->rows(); ++row)
    for (int k = pattern->row_start[row]; k < pattern->row_start[row + 1]; ++k) {
      pattern->mirror[k] = next[pattern->column[k]]++;
      if (pattern->column[k] == row) pattern->diagonal[row] = k;
    }
}

}  // namespace

void findPattern(const Assembly& assembly, const std::vector<int>& order, BlockPattern* pattern) {
  pattern->copies = order;
  pattern->row_of.assign(assembly.mesh().numCopies(), -1);
  for (std::size_t r = 0; r < order.size(); ++r) pattern->row_of[order[r]] = static_cast<int>(r);
  findColumns(assembly, pattern);
  findTerms(assembly, pattern);
  findMirrors(pattern);
}

std::vector<double> diagonalScale(const Assembly& assembly, const SystemFactors& factors) {
  const Material& material = assembly.material();
  std::vector<double> scale(assembly.mesh().numCopies(), 0);
  for (std::size_t p = 0; p < assembly.mesh().parts().size(); ++p) {
    const int part = static_cast<int>(p);
    const Gradients g = assembly.rotatedGradients(part);
    for (int I = 0; I < 4; ++I) {
      const double stiffness =
          assembly.volume(part) * (material.lambda() + 4 * material.mu()) / 3 * g.col(I).squaredNorm();
      scale[assembly.mesh().parts()[p].copies[I]] +=
          factors.stiffness * stiffness +
          (assembly.consistentMass() ? factors.mass * assembly.massProduct(part, I, I) : 0);
    }
  }
  if (!assembly.consistentMass())
    for (std::size_t c = 0; c < scale.size(); ++c) scale[c] += factors.mass * assembly.masses()[c];
  return scale;
}

// With g_I = R b_I and S = Σ V_p g_I g_Jᵀ over the terms, the block of K that couples row corner I to column corner J
// is
//   λ S + μ Sᵀ + μ tr(S) I.
template <typename T>
void BlockAssembler<T>::assemble(const Assembly& assembly, const BlockPattern& pattern, const SystemFactors& factors,
                                 const std::vector<double>& scale, std::vector<T>* blocks) {
  const int parts = static_cast<int>(assembly.mesh().parts().size());
  gradients_.resize(parts);
  weights_.resize(parts);
  parallelFor(parts, assembly.threads(), [&](int p) {
    gradients_[p] = assembly.rotatedGradients(p).template cast<T>();
    weights_[p] = factors.stiffness * assembly.volume(p);
  });
  const T lambda = static_cast<T>(assembly.material().lambda()), mu = static_cast<T>(assembly.material().mu());
  resizeWithRoom(BLOCK_SIZE * pattern.column.size(), blocks);
  parallelFor(pattern.rows(), assembly.threads(), [&](int row) {
    for (int k = pattern.diagonal[row]; k < pattern.row_start[row + 1]; ++k) {
      const double scales = scale[row] * scale[pattern.column[k]];
      Eigen::Matrix<T, 3, 3> S = Eigen::Matrix<T, 3, 3>::Zero();
      double mass = 0;
      for (int t = pattern.term_start[k]; t < pattern.term_start[k + 1]; ++t) {
        const int p = pattern.terms[t] / 16, I = pattern.terms[t] / 4 % 4, J = pattern.terms[t] % 4;
        const Eigen::Matrix<T, 3, 1> g = static_cast<T>(weights_[p] * scales) * gradients_[p].col(I);
        S.noalias() += g * gradients_[p].col(J).transpose();
        if (assembly.consistentMass()) mass += assembly.massProduct(p, I, J);
      }
      if (!assembly.consistentMass() && k == pattern.diagonal[row]) mass = assembly.masses()[pattern.copies[row]];
      const T on_diagonal = mu * S.trace() + static_cast<T>(factors.mass * mass * scales);
      Eigen::Map<Eigen::Matrix<T, 4, 3>> block(&(*blocks)[static_cast<std::size_t>(BLOCK_SIZE) * k]);
      Eigen::Map<Eigen::Matrix<T, 4, 3>> mirror(&(*blocks)[static_cast<std::size_t>(BLOCK_SIZE) * pattern.mirror[k]]);
      block.setZero();
      block.template topRows<3>() = lambda * S + mu * S.transpose();
      block.template topRows<3>().diagonal().array() += on_diagonal;
      if (k == pattern.diagonal[row]) continue;
      mirror.setZero();
      mirror.template topRows<3>() = block.template topRows<3>().transpose();
    }
  });
}

template class BlockAssembler<float>;
template class BlockAssembler<double>;

}  // namespace incision
