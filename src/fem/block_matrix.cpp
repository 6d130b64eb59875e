#include "incision/fem/block_matrix.h"

#include <algorithm>

#include "incision/fem/parallel.h"

namespace incision {
namespace {

/// Blocks of one row and the terms of each, sorted by column.
void collectRow(const Assembly& assembly, const BlockPattern& pattern, int row,
                std::vector<std::pair<int, int>>* found) {
  found->clear();
  const int copy = pattern.copies[row];
  for (int k = assembly.cornerStart()[copy]; k < assembly.cornerStart()[copy + 1]; ++k) {
    const Corner& corner = assembly.corners()[k];
    const Part& part = assembly.mesh().parts()[corner.part];
    for (int J = 0; J < 4; ++J) {
      const int column = pattern.row_of[part.copies[J]];
      if (column >= 0) found->emplace_back(column, 16 * corner.part + 4 * corner.node + J);
    }
  }
  std::sort(found->begin(), found->end());
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

BlockPattern blockPattern(const Assembly& assembly, const std::vector<int>& order) {
  BlockPattern pattern;
  pattern.copies = order;
  pattern.row_of.assign(assembly.mesh().numCopies(), -1);
  for (std::size_t r = 0; r < order.size(); ++r) pattern.row_of[order[r]] = static_cast<int>(r);
  pattern.row_start.push_back(0);
  pattern.term_start.push_back(0);
  std::vector<std::pair<int, int>> found;
  for (int row = 0; row < pattern.rows(); ++row) {
    collectRow(assembly, pattern, row, &found);
    for (std::size_t i = 0; i < found.size(); ++i) {
      if (i > 0 && found[i].first == found[i - 1].first) continue;
      pattern.column.push_back(found[i].first);
      for (std::size_t j = i; found[i].first >= row && j < found.size() && found[j].first == found[i].first; ++j)
        pattern.terms.push_back(found[j].second);
      pattern.term_start.push_back(static_cast<int>(pattern.terms.size()));
    }
    pattern.row_start.push_back(static_cast<int>(pattern.column.size()));
  }
  findMirrors(&pattern);
  return pattern;
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
  blocks->resize(BLOCK_SIZE * pattern.column.size());
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
