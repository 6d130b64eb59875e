#include "incision/solver/sparse_cholesky.h"

#include <cholmod.h>
#include <omp.h>

#include <algorithm>
#include <cassert>
#include <new>

#include "incision/solver/block_pool.h"
#include "turns.h"

namespace incision {
namespace {

/// From this many blocks on METIS orders better than approximate minimum degree.
constexpr std::size_t METIS_FROM = 3000;

/// CHOLMOD opens parallel regions of its own; within this scope they get one thread, and its memory comes from the
/// pool.
class CholmodScope {
 public:
  explicit CholmodScope(BlockPool* pool) : pool_(pool), levels_(omp_get_max_active_levels()) {
    omp_set_max_active_levels(0);
  }
  ~CholmodScope() { omp_set_max_active_levels(levels_); }

 private:
  BlockPool::Scope pool_;
  int levels_;
};

/// The pattern of whole blocks, for ordering.
LowerTriangle blocksOf(const LowerTriangle& pattern, int block) {
  LowerTriangle blocks;
  blocks.column_start.push_back(0);
  for (int c = 0; c < pattern.size(); c += block) {
    for (int k = pattern.column_start[c]; k < pattern.column_start[c + 1]; ++k)
      if (pattern.row[k] % block == 0) blocks.row.push_back(pattern.row[k] / block);
    blocks.column_start.push_back(static_cast<int>(blocks.row.size()));
  }
  return blocks;
}

/// A CHOLMOD view of a pattern; `values` may be null.
cholmod_sparse viewOf(const LowerTriangle& pattern, const double* values) {
  cholmod_sparse view{};
  view.nrow = view.ncol = static_cast<std::size_t>(pattern.size());
  view.nzmax = pattern.row.size();
  view.p = const_cast<int*>(pattern.column_start.data());
  view.i = const_cast<int*>(pattern.row.data());
  view.x = const_cast<double*>(values);
  view.stype = -1;
  view.itype = CHOLMOD_INT;
  view.xtype = values ? CHOLMOD_REAL : CHOLMOD_PATTERN;
  view.dtype = CHOLMOD_DOUBLE;
  view.sorted = view.packed = 1;
  return view;
}

}  // namespace

struct SparseCholesky::Cholmod {
  BlockPool pool;
  cholmod_common common;
  cholmod_factor* factor = nullptr;
  cholmod_dense *solution = nullptr, *scratch_y = nullptr, *scratch_e = nullptr;
  LowerTriangle pattern;
  std::vector<double> factorised;  // the values of the factor; empty: there is none

  Cholmod() {
    const CholmodScope scope(&pool);
    cholmod_start(&common);
    common.print = 0;
    common.quick_return_if_not_posdef = 1;
    common.final_ll = 1;  // never L D Lᵀ, which accepts indefinite matrices
  }
  ~Cholmod() {
    const CholmodScope scope(&pool);
    cholmod_free_factor(&factor, &common);
    for (cholmod_dense** dense : {&solution, &scratch_y, &scratch_e}) cholmod_free_dense(dense, &common);
    cholmod_finish(&common);
  }
  bool findOrder(cholmod_sparse* matrix, int* order);
  std::vector<int> blockOrder(int block);
};

SparseCholesky::SparseCholesky() : cholmod_(std::make_unique<Cholmod>()) {}
SparseCholesky::~SparseCholesky() = default;

bool SparseCholesky::Cholmod::findOrder(cholmod_sparse* matrix, int* order) {
  if (matrix->nrow < METIS_FROM) return cholmod_amd(matrix, nullptr, 0, order, &common) != 0;
  const auto turn = turnAtMetis();
  return cholmod_metis(matrix, nullptr, 0, 1, order, &common) != 0;
}

std::vector<int> SparseCholesky::Cholmod::blockOrder(int block) {
  const LowerTriangle blocks = blocksOf(pattern, block);
  cholmod_sparse view = viewOf(blocks, nullptr);
  std::vector<int> order(blocks.size());
  if (!findOrder(&view, order.data())) throw std::bad_alloc();
  std::vector<int> expanded;
  expanded.reserve(block * order.size());
  for (int b : order)
    for (int i = 0; i < block; ++i) expanded.push_back(block * b + i);
  return expanded;
}

void SparseCholesky::analyse(const LowerTriangle& pattern, int block) {
  Cholmod& c = *cholmod_;
  const CholmodScope scope(&c.pool);
  c.pattern = pattern;
  cholmod_free_factor(&c.factor, &c.common);
  for (cholmod_dense** dense : {&c.solution, &c.scratch_y, &c.scratch_e}) cholmod_free_dense(dense, &c.common);
  c.pool.release();
  c.factorised.clear();
  std::vector<int> order = c.blockOrder(block);
  c.common.nmethods = 1;
  c.common.method[0].ordering = CHOLMOD_GIVEN;
  c.common.postorder = 1;
  cholmod_sparse view = viewOf(c.pattern, nullptr);
  c.factor = cholmod_analyze_p(&view, order.data(), nullptr, 0, &c.common);
  if (!c.factor) throw std::bad_alloc();
}

bool SparseCholesky::factorise(const std::vector<double>& values) {
  Cholmod& c = *cholmod_;
  const CholmodScope scope(&c.pool);
  assert(values.size() == c.pattern.row.size());
  if (values == c.factorised) return true;
  c.factorised.clear();
  cholmod_sparse view = viewOf(c.pattern, values.data());
  {
    const auto turn = turnAtBlas();
    cholmod_factorize(&view, c.factor, &c.common);
  }
  if (c.common.status == CHOLMOD_OUT_OF_MEMORY) throw std::bad_alloc();
  const bool done = c.common.status == CHOLMOD_OK && c.factor->minor == c.factor->n;
  if (done) c.factorised = values;
  return done;
}

void SparseCholesky::solve(const std::vector<double>& b, std::vector<double>* x) {
  Cholmod& c = *cholmod_;
  const CholmodScope scope(&c.pool);
  cholmod_dense right{};
  right.nrow = right.nzmax = right.d = b.size();
  right.ncol = 1;
  right.x = const_cast<double*>(b.data());
  right.xtype = CHOLMOD_REAL;
  right.dtype = CHOLMOD_DOUBLE;
  {
    const auto turn = turnAtBlas();
    if (!cholmod_solve2(CHOLMOD_A, c.factor, &right, nullptr, &c.solution, nullptr, &c.scratch_y, &c.scratch_e,
                        &c.common))
      throw std::bad_alloc();
  }
  const double* solution = static_cast<const double*>(c.solution->x);
  x->assign(solution, solution + b.size());
}

}  // namespace incision
