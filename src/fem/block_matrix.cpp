#include "incision/fem/block_matrix.h"

#include <algorithm>
#include <cmath>
#include <cstring>

#include "incision/base/parallel.h"

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

/// Four numbers in a vector register.
template <typename T>
struct Register;
template <>
struct Register<float> {
  using Type = float __attribute__((vector_size(16)));
};
template <>
struct Register<double> {
  using Type = double __attribute__((vector_size(32)));
};
template <typename T>
using RegisterOf = typename Register<T>::Type;

// By reference: a register of four doubles cannot be returned alike on all processors.
template <typename T>
void load(const T* values, RegisterOf<T>* lanes) {
  std::memcpy(lanes, values, sizeof *lanes);
}

template <typename T>
void add(const RegisterOf<T>& more, T* values) {
  RegisterOf<T> sum;
  load(values, &sum);
  sum += more;
  std::memcpy(values, &sum, sizeof sum);
}

/// Adds a bᵀ to blocks; both vectors are read as four numbers. The nine products stand in a block as four, four and
/// one.
template <typename T>
class OuterProduct {
 public:
  explicit OuterProduct(const T* a) {
    load(a, &a_);
    first_ = __builtin_shufflevector(a_, a_, 0, 1, 2, 0);
    second_ = __builtin_shufflevector(a_, a_, 1, 2, 0, 1);
  }
  void addTo(T* block, const T* with) const {
    RegisterOf<T> b;
    load(with, &b);
    add<T>(first_ * __builtin_shufflevector(b, b, 0, 0, 0, 1), block);
    add<T>(second_ * __builtin_shufflevector(b, b, 1, 1, 2, 2), block + 4);
    block[8] += a_[2] * b[2];
  }

 private:
  RegisterOf<T> a_, first_, second_;
};

/// Adds g_I g_Jᵀ for the corners of a row, of those parts that are asked for, to its blocks.
template <typename T, typename Test>
void addProducts(const Assembly& assembly, const BlockPattern& pattern, int row, const std::vector<T>& gradients,
                 const Test& isOf, T* blocks) {
  const int copy = pattern.copies[row];
  for (const Corner& corner : assembly.corners()[copy]) {
    if (!isOf(corner.part)) continue;
    const T* g = &gradients[12 * static_cast<std::size_t>(corner.part)];
    const OuterProduct<T> g_I(g + 3 * corner.node);
    for (int J = 0; J < 4; ++J)
      if (const int slot = slotOf(assembly, pattern, row, corner, J); slot >= 0)
        g_I.addTo(blocks + BLOCK_SIZE * slot, g + 3 * J);
  }
}

/// Makes λ S + μ Sᵀ + μ tr(S) I, scaled, of a block S that has the factor μ in it already.
template <typename T>
void turnIntoStiffness(T lame_ratio, T scales, T* S) {
  Eigen::Map<Eigen::Matrix<T, 3, 3>> block(S);
  const Eigen::Matrix<T, 3, 3> scaled = scales * block;
  block = lame_ratio * scaled + scaled.transpose();
  block.diagonal().array() += scaled.trace();
}

template <typename T>
void addConsistentMass(const Assembly& assembly, const BlockPattern& pattern, int row, const std::vector<double>& scale,
                       double factor, T* blocks) {
  const int copy = pattern.copies[row];
  for (const Corner& corner : assembly.corners()[copy]) {
    for (int J = 0; J < 4; ++J) {
      const int slot = slotOf(assembly, pattern, row, corner, J);
      if (slot < 0) continue;
      const double scales = scale[row] * scale[pattern.column[pattern.row_start[row] + slot]];
      const T mass = static_cast<T>(factor * assembly.massProduct(corner.part, corner.node, J) * scales);
      for (int i = 0; i < 3; ++i) blocks[BLOCK_SIZE * slot + 4 * i] += mass;
    }
  }
}

/// Adds what tension has found to the blocks of a row, in their units.
template <typename T, typename Scales>
void addTension(const Assembly& assembly, const BlockPattern& pattern, int row, const Tension& tension,
                const Scales& scalesOf, double least, T* blocks) {
  thread_local std::vector<T> sums;
  const int count = pattern.row_start[row + 1] - pattern.row_start[row];
  sums.assign(static_cast<std::size_t>(count), T(0));
  for (const Corner& corner : assembly.corners()[pattern.copies[row]]) {
    const TensionProducts& products = tension.products(static_cast<int>(corner.part));
    for (int J = 0; J < 4; ++J)
      if (const int slot = slotOf(assembly, pattern, row, corner, J); slot >= 0)
        sums[slot] += static_cast<T>(least * least * products.of(static_cast<int>(corner.node), J));
  }
  for (int k = 0; k < count; ++k) {
    const T pull = scalesOf(k) * sums[k];
    for (int i = 0; i < 3; ++i) blocks[BLOCK_SIZE * k + 4 * i] += pull;
  }
}

/// Adds to the blocks of a row what its parts make, of which some have one ratio λ/μ and some another. The sums of each
/// ratio are those that a row all of one ratio has, so that a block and the one opposite to it stay equal.
template <typename T, typename Scales>
void addByRatio(const Assembly& assembly, const BlockPattern& pattern, int row, const std::vector<T>& gradients,
                const Scales& scalesOf, T* blocks) {
  thread_local std::vector<T> sums;
  const Materials& materials = assembly.materials();
  const int count = pattern.row_start[row + 1] - pattern.row_start[row];
  const auto ratioOf = [&](int part) { return materials.lameRatio(assembly.mesh().parts()[part].element); };
  for (int ratio = 0; ratio < static_cast<int>(materials.lameRatios().size()); ++ratio) {
    const auto isOf = [&](int part) { return ratioOf(part) == ratio; };
    const auto& corners = assembly.corners()[pattern.copies[row]];
    if (std::none_of(corners.begin(), corners.end(), [&](const Corner& corner) { return isOf(corner.part); })) continue;
    sums.assign(static_cast<std::size_t>(BLOCK_SIZE) * count + 1, T(0));  // a column is read as four
    addProducts(assembly, pattern, row, gradients, isOf, sums.data());
    for (int k = 0; k < count; ++k)
      turnIntoStiffness(static_cast<T>(materials.lameRatios()[ratio]), scalesOf(k), &sums[BLOCK_SIZE * k]);
    for (int i = 0; i < BLOCK_SIZE * count; ++i) blocks[i] += sums[i];
  }
}

/// Adds h_i h_jᵀ for all the patches that use the copy of a row.
template <typename T>
void addPatches(const Assembly& assembly, const BlockPattern& pattern, int row, const std::vector<T>& gradients,
                T* blocks) {
  const Patches& patches = *assembly.patches();
  const int copy = pattern.copies[row];
  for (const auto& [a, i] : patches.uses()[copy]) {
    const T* h = &gradients[3 * static_cast<std::size_t>(patches.copies().start(a))];
    const OuterProduct<T> h_i(h + 3 * i);
    for (int j = 0; j < patches.numCopies(a); ++j)
      if (const int slot = patchSlotOf(patches, pattern, row, a, i, j); slot >= 0)
        h_i.addTo(blocks + BLOCK_SIZE * slot, h + 3 * j);
  }
}

}  // namespace

double diagonalOf(const Assembly& assembly, const SystemFactors& factors, int copy) {
  return factors.mass * assembly.massDiagonal()[copy] + factors.stiffness * assembly.stiffnessDiagonal()[copy];
}

// With g_I = R b_I and S = Σ V_p g_I g_Jᵀ over the parts that hold both copies, the block of K that couples copy I to
// copy J is
//   λ S + μ Sᵀ + μ tr(S) I,
// or with averaged pressure, ∇θ_a = Σ V_p g_I / V_a being summed over the corners of patch a that use a copy,
//   Σ_a λ V_a ∇_I θ_a ∇_J θ_aᵀ + μ Sᵀ + μ tr(S) I.
// The roots of the weights go into the gradients, so that the two halves of the matrix round alike; the least scale
// goes with them, to keep all numbers within the range of a float whatever the units.
template <typename T>
void BlockAssembler<T>::assemble(const Assembly& assembly, const BlockPattern& pattern, const SystemFactors& factors,
                                 const std::vector<double>& scale, std::vector<T>* blocks) {
  const double least = *std::min_element(scale.begin(), scale.end());
  findGradients(assembly, factors.stiffness, least);
  const bool averaged = assembly.patches() != nullptr;
  if (averaged) findPatchGradients(assembly, pattern, factors.stiffness, scale);
  static const std::vector<double> NO_PRESSURE = {0};
  const std::vector<double>& ratios = averaged ? NO_PRESSURE : assembly.materials().lameRatios();
  const T lame_ratio = static_cast<T>(ratios[0]);
  const bool one_ratio = ratios.size() == 1, pulls = factors.tension && factors.tension->acts();
  resizeWithRoom(BLOCK_SIZE * pattern.column.size() + 1, blocks);  // a column is read as four
  parallelFor(pattern.rows(), assembly.threads(), [&](int row) {
    const int begin = pattern.row_start[row], end = pattern.row_start[row + 1];
    T* first = &(*blocks)[static_cast<std::size_t>(BLOCK_SIZE) * begin];
    std::fill_n(first, BLOCK_SIZE * (end - begin), T(0));
    const auto scalesOf = [&](int k) {
      return static_cast<T>(scale[row] / least) * static_cast<T>(scale[pattern.column[begin + k]] / least);
    };
    if (one_ratio) {
      addProducts(
          assembly, pattern, row, gradients_, [](int) { return true; }, first);
      for (int k = 0; k < end - begin; ++k) turnIntoStiffness(lame_ratio, scalesOf(k), first + BLOCK_SIZE * k);
    } else {
      addByRatio(assembly, pattern, row, gradients_, scalesOf, first);
    }
    if (averaged) addPatches(assembly, pattern, row, patch_gradients_, first);
    if (pulls) addTension(assembly, pattern, row, *factors.tension, scalesOf, least, first);
    if (assembly.consistentMass()) return addConsistentMass(assembly, pattern, row, scale, factors.mass, first);
    const double mass = factors.mass * assembly.masses()[pattern.copies[row]] * scale[row] * scale[row];
    T* diagonal = first + BLOCK_SIZE * (pattern.diagonal[row] - begin);
    for (int i = 0; i < 3; ++i) diagonal[4 * i] += static_cast<T>(mass);
  });
}

template <typename T>
void BlockAssembler<T>::findGradients(const Assembly& assembly, double stiffness, double least) {
  const int parts = static_cast<int>(assembly.mesh().parts().size());
  resizeWithRoom(12 * static_cast<std::size_t>(parts) + 1, &gradients_);  // a column is read as four
  parallelFor(parts, assembly.threads(), [&](int p) {
    const double mu = assembly.lameOf(p).mu;
    const double root = least * std::sqrt(stiffness * assembly.volume(p) * mu);
    Eigen::Map<Eigen::Matrix<T, 3, 4>> g(&gradients_[12 * static_cast<std::size_t>(p)]);
    g = (root * assembly.rotatedGradients(p)).template cast<T>();
  });
}

template <typename T>
void BlockAssembler<T>::findPatchGradients(const Assembly& assembly, const BlockPattern& pattern, double stiffness,
                                           const std::vector<double>& scale) {
  const Patches& patches = *assembly.patches();
  const std::size_t copies = patches.copies().values().size();
  resizeWithRoom(copies, &volume_gradients_);
  resizeWithRoom(3 * copies + 1, &patch_gradients_);  // a column is read as four
  parallelFor(patches.count(), assembly.threads(), [&](int a) {
    const int first = patches.copies().start(a), count = patches.numCopies(a);
    Vec3* const h = volume_gradients_.data() + first;
    std::fill_n(h, count, Vec3::Zero());
    double volume = 0;
    for (int n = patches.parts().start(a); n < patches.parts().start(a + 1); ++n) {
      const int p = patches.parts().values()[n];
      const Gradients g = assembly.rotatedGradients(p);
      for (int I = 0; I < 4; ++I) h[patches.indexOf(n, I)] += assembly.volume(p) * g.col(I);
      volume += assembly.volume(p);
    }
    const int element = assembly.mesh().parts()[patches.parts()[a][0]].element;
    const double root = std::sqrt(stiffness * assembly.materials().lame(element).lambda / volume);
    for (int i = 0; i < count; ++i) {
      const int row = pattern.row_of[patches.copies()[a][i]];
      if (row < 0) continue;
      Eigen::Map<Eigen::Matrix<T, 3, 1>> scaled(&patch_gradients_[3 * static_cast<std::size_t>(first + i)]);
      scaled = (root * scale[row] * h[i]).template cast<T>();
    }
  });
}

template class BlockAssembler<float>;
template class BlockAssembler<double>;

}  // namespace incision
