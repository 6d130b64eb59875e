#pragma once

#include <Eigen/SparseCore>

#include "report/locking/problem.h"
#include "support/rig.h"

namespace incision::report {

/// Where the dilatation of linear tetrahedra is averaged, against locking.
enum class Averaging {
  NONE,    ///< plain elements
  COPIES,  ///< over the parts round each copy
  CELLS,   ///< over the parts of six elements that follow each other, the cell of a grid, where they hang together
};

using Sparse = Eigen::SparseMatrix<double>;
using RowSparse = Eigen::SparseMatrix<double, Eigen::RowMajor>;
using Vector = Eigen::VectorXd;

/// Poisson's ratio of what averaging leaves to the elements: with less, dilatations that cancel in the means cost too
/// little; with more, the elements lock again.
inline double BASE_RATIO = 0.3; inline int MODE=0;

/// The linear system K u = f over the free copies of a body at rest, K = K_0 + Dᵀ W D.
///
/// Plain elements have no D. Else K_0 has the same μ and the λ_0 that belongs to BASE_RATIO, and a row of D gives the
/// mean dilatation Σ_p V_pc tr ∇u_p / V_c of a copy or cell c, V_pc being the share of part p in it, V_p / 4 or V_p, and
/// V_c their sum; W = (λ − λ_0) V_c.
struct Tissue {
  Sparse K_0;
  RowSparse D;
  Vector W;
  Vector f;
  double work_of_held = 0;  ///< u·K u of the held copies' displacements alone

  Sparse matrix() const;  ///< K
};

/// The body of a problem on one mesh, maybe cut.
class Specimen {
 public:
  Specimen(const Problem& problem, TetMesh mesh, const std::vector<PlaneCut>& cuts = {});

  Tissue tissue(double poisson_ratio, Averaging averaging) const;
  /// What the problem asks, of a solution over the free copies.
  double answer(const Tissue& tissue, const Vector& u) const;
  /// What the body's volume gains by it, as a share.
  double dilatation(const Vector& u) const;

  const Rig& rig() const { return rig_; }
  int freedoms() const { return 3 * static_cast<int>(free_.size()); }

 private:
  std::vector<int> cellOfParts(int* count) const;
  Sparse meanDilatations(Averaging averaging, Vector* volumes) const;
  Vector heldDisplacements() const;

  Problem problem_;
  Rig rig_;
  std::vector<int> free_;
  Sparse select_;  // columns: the free copies' displacements
};

}  // namespace incision::report
