#include "incision/fem/block_matrix.h"

#include <algorithm>
#include <cmath>

#include "incision/mesh/parallel.h"

namespace incision {
namespace {

/// Resizes without keeping the values, and with room for the next cuts: a body's largest arrays must not move for each.
template <typename T>
void resizeWithRoom(std::size_t size, std::vector<T>* values) {
  if (values->capacity() < size) {
    values->clear();
    values->reserve(size + size / 4);
  }
  values->resize(size);
}

/// Adds g_I g_Jᵀ for all the corners of a row to its blocks, whose padding takes what comes.
template <typename T>
void addProducts(const Assembly& assembly, const BlockPattern& pattern, int row, const std::vector<T>& gradients,
                 T* blocks) {
  using Column = Eigen::Matrix<T, 4, 1>;
  const int copy = pattern.copies[row];
  for (int k = assembly.cornerStart()[copy]; k < assembly.cornerStart()[copy + 1]; ++k) {
    const Corner& corner = assembly.corners()[k];
    const T* g = &gradients[12 * static_cast<std::size_t>(corner.part)];
    const int* slots = &pattern.slots[16 * static_cast<std::size_t>(corner.part) + 4 * corner.node];
    const Column g_I = Eigen::Map<const Column>(g + 3 * corner.node);
    for (int J = 0; J < 4; ++J) {
      if (slots[J] < 0) continue;
      T* S = blocks + BLOCK_SIZE * slots[J];
      for (int j = 0; j < 3; ++j) Eigen::Map<Column>(S + 4 * j) += g_I * g[3 * J + j];
    }
  }
}

template <typename T>
void addConsistentMass(const Assembly& assembly, const BlockPattern& pattern, int row, const std::vector<double>& scale,
                       double factor, T* blocks) {
  const int copy = pattern.copies[row];
  for (int k = assembly.cornerStart()[copy]; k < assembly.cornerStart()[copy + 1]; ++k) {
    const Corner& corner = assembly.corners()[k];
    for (int J = 0; J < 4; ++J) {
      const int slot = pattern.slots[16 * static_cast<std::size_t>(corner.part) + 4 * corner.node + J];
      if (slot < 0) continue;
      const double scales = scale[row] * scale[pattern.column[pattern.row_start[row] + slot]];
      const T mass = static_cast<T>(factor * assembly.massProduct(corner.part, corner.node, J) * scales);
      for (int i = 0; i < 3; ++i) blocks[BLOCK_SIZE * slot + 5 * i] += mass;
    }
  }
}

}  // namespace

double diagonalOf(const Assembly& assembly, const SystemFactors& factors, int copy) {
  return factors.mass * assembly.massDiagonal()[copy] + factors.stiffness * assembly.stiffnessDiagonal()[copy];
}

// With g_I = R b_I and S = Σ V_p g_I g_Jᵀ over the parts that hold both copies, the block of K that couples copy I to
// copy J is
//   λ S + μ Sᵀ + μ tr(S) I.
// The roots of the weights go into the gradients, so that the two halves of the matrix round alike; the least scale
// goes with them, to keep all numbers within the range of a float whatever the units.
template <typename T>
void BlockAssembler<T>::assemble(const Assembly& assembly, const BlockPattern& pattern, const SystemFactors& factors,
                                 const std::vector<double>& scale, std::vector<T>* blocks) {
  const int parts = static_cast<int>(assembly.mesh().parts().size());
  const double mu = assembly.material().mu(), least = *std::min_element(scale.begin(), scale.end());
  resizeWithRoom(12 * static_cast<std::size_t>(parts) + 1, &gradients_);  // a column is read as four
  parallelFor(parts, assembly.threads(), [&](int p) {
    const double root = least * std::sqrt(factors.stiffness * assembly.volume(p) * mu);
    Eigen::Map<Eigen::Matrix<T, 3, 4>> g(&gradients_[12 * static_cast<std::size_t>(p)]);
    g = (root * assembly.rotatedGradients(p)).template cast<T>();
  });
  const T lambda = static_cast<T>(assembly.material().lambda() / mu);
  resizeWithRoom(BLOCK_SIZE * pattern.column.size(), blocks);
  parallelFor(pattern.rows(), assembly.threads(), [&](int row) {
    const int begin = pattern.row_start[row], end = pattern.row_start[row + 1];
    T* first = &(*blocks)[static_cast<std::size_t>(BLOCK_SIZE) * begin];
    std::fill_n(first, BLOCK_SIZE * (end - begin), T(0));
    addProducts(assembly, pattern, row, gradients_, first);
    for (int k = begin; k < end; ++k) {
      Eigen::Map<Eigen::Matrix<T, 4, 3>> block(first + BLOCK_SIZE * (k - begin));
      const T scales = static_cast<T>(scale[row] / least) * static_cast<T>(scale[pattern.column[k]] / least);
      const Eigen::Matrix<T, 3, 3> S = scales * block.template topRows<3>();
      block.template topRows<3>() = lambda * S + S.transpose();
      block.template topRows<3>().diagonal().array() += S.trace();
      block.row(3).setZero();
    }
    if (assembly.consistentMass()) return addConsistentMass(assembly, pattern, row, scale, factors.mass, first);
    const double mass = factors.mass * assembly.masses()[pattern.copies[row]] * scale[row] * scale[row];
    for (int i = 0; i < 3; ++i)
      (*blocks)[BLOCK_SIZE * static_cast<std::size_t>(pattern.diagonal[row]) + 5 * i] += static_cast<T>(mass);
  });
}

template class BlockAssembler<float>;
template class BlockAssembler<double>;

}  // namespace incision
