#include "report/locking/nodal.h"

#include "incision/solver/sparse_cholesky.h"
#include "report/locking/specimen.h"
#include "support/loads.h"

namespace incision::report {
namespace {

using Sparse = Eigen::SparseMatrix<double>;

/// √(λ V_c) ∇θ_c of every copy, a row each, over the displacements of the free copies.
Sparse meanDilatations(const Rig& rig, const std::vector<int>& copies, double lambda) {
  const Assembly& assembly = rig.step.assembly();
  const std::vector<Part>& parts = rig.mesh.parts();
  std::vector<double> volume(rig.mesh.numCopies(), 0);
  for (std::size_t p = 0; p < parts.size(); ++p)
    for (int copy : parts[p].copies) volume[copy] += assembly.volume(static_cast<int>(p)) / 4;
  std::vector<int> row_of(rig.mesh.numCopies(), -1);
  for (std::size_t k = 0; k < copies.size(); ++k) row_of[copies[k]] = static_cast<int>(k);

  std::vector<Eigen::Triplet<double>> entries;
  for (int p = 0; p < static_cast<int>(parts.size()); ++p) {
    const Gradients g = assembly.rotatedGradients(p);
    for (int at : parts[p].copies)
      for (int J = 0; J < 4; ++J)
        if (const int row = row_of[parts[p].copies[J]]; row >= 0)
          for (int i = 0; i < 3; ++i)
            entries.emplace_back(at, 3 * row + i, std::sqrt(lambda / volume[at]) * assembly.volume(p) / 4 * g(i, J));
  }
  Sparse D(rig.mesh.numCopies(), 3 * static_cast<int>(copies.size()));
  D.setFromTriplets(entries.begin(), entries.end());
  return D;
}

/// Solves K u = f by the core's Cholesky.
Eigen::VectorXd solve(const Sparse& K, const Eigen::VectorXd& f) {
  LowerTriangle lower;
  lower.column_start.push_back(0);
  std::vector<double> values, x;
  for (int j = 0; j < K.outerSize(); ++j) {
    for (Sparse::InnerIterator entry(K, j); entry; ++entry)
      if (entry.row() >= j) {
        lower.row.push_back(static_cast<int>(entry.row()));
        values.push_back(entry.value());
      }
    lower.column_start.push_back(static_cast<int>(lower.row.size()));
  }
  SparseCholesky cholesky;
  cholesky.analyse(lower, 3);
  if (!cholesky.factorise(values)) throw std::runtime_error("the matrix is not positive definite");
  cholesky.solve({f.begin(), f.end()}, &x);
  return Eigen::Map<const Eigen::VectorXd>(x.data(), f.size());
}

}  // namespace

NodalAverage nodalAverage(const Problem& problem, const TetMesh& mesh, double poisson_ratio) {
  // Without volume change of their own, elements have λ = 0 and the same μ.
  const Material tissue{YOUNG_MODULUS, poisson_ratio, 1, 0, 0};
  RigSettings settings = statics(2 * tissue.mu(), 0);
  settings.conditions = {Vec3::Zero(), problem.clamps, problem.loads};
  const Rig rig(mesh, settings);
  const std::vector<int> copies = rig.freeCopies();
  const Sparse D = meanDilatations(rig, copies, tissue.lambda());
  const Sparse K = systemMatrix(rig.step.assembly(), {0, 1}, copies) + Sparse(D.transpose() * D);

  const std::vector<Vec3> forces = loadForces(rig.mesh, problem.loads.front());
  Eigen::VectorXd f(K.rows());
  Vec3 force = Vec3::Zero();
  for (std::size_t k = 0; k < copies.size(); ++k) f.segment<3>(3 * static_cast<int>(k)) = forces[copies[k]];
  for (const Vec3& nodal : forces) force += nodal;
  NodalAverage result{};
  result.answer = f.dot(solve(K, f)) / force.norm();
  result.blocks = static_cast<long>(K.nonZeros()) / BLOCK_SIZE;
  return result;
}

}  // namespace incision::report
