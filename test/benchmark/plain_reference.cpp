#include "benchmark/plain_reference.h"

#include <omp.h>

#include <Eigen/LU>
#include <Eigen/SVD>
#include <algorithm>
#include <stdexcept>

#include "benchmark/lumped_mass.h"
#include "incision/fem/boundary.h"

namespace incision::bench {
namespace {

using Matrix12 = Eigen::Matrix<double, 12, 12>;

/// Columns x1 − x0, x2 − x0, x3 − x0.
Mat3 edges(const std::vector<Vec3>& x, const std::array<int, 4>& nodes) {
  Mat3 D;
  for (int i = 0; i < 3; ++i) D.col(i) = x[nodes[i + 1]] - x[nodes[0]];
  return D;
}

/// Stress from strain (xx, yy, zz, xy, yz, zx; the last three doubled).
Eigen::Matrix<double, 6, 6> elasticity(const Material& material) {
  Eigen::Matrix<double, 6, 6> D = Eigen::Matrix<double, 6, 6>::Zero();
  D.topLeftCorner<3, 3>().setConstant(material.lambda());
  D.topLeftCorner<3, 3>().diagonal().array() += 2 * material.mu();
  D.bottomRightCorner<3, 3>().diagonal().setConstant(material.mu());
  return D;
}

/// K_e = V Bᵀ D B.
Matrix12 elementStiffness(const Mat3& inverse_rest, double volume, const Material& material) {
  Eigen::Matrix<double, 4, 3> gradients;
  gradients.bottomRows<3>() = inverse_rest;
  gradients.row(0) = -inverse_rest.colwise().sum();
  Eigen::Matrix<double, 6, 12> B = Eigen::Matrix<double, 6, 12>::Zero();
  for (int I = 0; I < 4; ++I)
    for (int i = 0; i < 3; ++i) {
      const int j = (i + 1) % 3;
      B(i, 3 * I + i) = gradients(I, i);
      B(3 + i, 3 * I + i) = gradients(I, j);
      B(3 + i, 3 * I + j) = gradients(I, i);
    }
  return volume * B.transpose() * elasticity(material) * B;
}

/// Where entry (row, column) of the lower triangle lies among the values.
int slotOf(const Eigen::SparseMatrix<double>& A, int row, int column) {
  const int* first = A.innerIndexPtr() + A.outerIndexPtr()[column];
  const int* last = A.innerIndexPtr() + A.outerIndexPtr()[column + 1];
  return static_cast<int>(std::lower_bound(first, last, row) - A.innerIndexPtr());
}

}  // namespace

PlainReference::PlainReference(const Scene& scene, TetMesh mesh)
    : scene_(scene), mesh_(std::move(mesh)), masses_(lumpedMasses(scene, mesh_)), x_(mesh_.nodes) {
  v_.assign(x_.size(), Vec3::Zero());
  int unknowns = 0;
  for (int hold : heldNodes(mesh_, scene.boundary)) {
    unknown_.push_back(hold >= 0 ? -1 : unknowns);
    if (hold < 0) unknowns += 3;
  }
  for (const auto& nodes : mesh_.elements) {
    const Mat3 Dm = edges(x_, nodes);
    elements_.push_back({Dm.inverse(), elementStiffness(Dm.inverse(), Dm.determinant() / 6, scene.body.material)});
  }
  A_.resize(unknowns, unknowns);
  findPattern();
  omp_set_max_active_levels(0);  // CHOLMOD's own threads make it slower
  cholmod_.analyzePattern(A_);
}

// The pattern never changes, so that a step has only the values to write.
void PlainReference::findPattern() {
  const auto unknown = [&](std::size_t e, int i) {
    const int first = unknown_[mesh_.elements[e][i / 3]];
    return first < 0 ? -1 : first + i % 3;
  };
  std::vector<Eigen::Triplet<double>> entries;
  for (std::size_t e = 0; e < elements_.size(); ++e)
    for (int i = 0; i < 12; ++i)
      for (int j = 0; j <= i; ++j)
        if (unknown(e, i) >= 0 && unknown(e, j) >= 0)
          entries.emplace_back(std::max(unknown(e, i), unknown(e, j)), std::min(unknown(e, i), unknown(e, j)), 0);
  A_.setFromTriplets(entries.begin(), entries.end());

  slots_.resize(elements_.size());
  for (std::size_t e = 0; e < elements_.size(); ++e)
    for (int i = 0, k = 0; i < 12; ++i)
      for (int j = 0; j <= i; ++j, ++k) {
        const int row = unknown(e, i), column = unknown(e, j);
        slots_[e][k] = row < 0 || column < 0 ? -1 : slotOf(A_, std::max(row, column), std::min(row, column));
      }
}

/// F = U Σ Vᵀ gives R = U Vᵀ; where that mirrors, the smallest singular direction is turned round.
Mat3 PlainReference::rotation(std::size_t element) const {
  const Mat3 F = edges(x_, mesh_.elements[element]) * elements_[element].inverse_rest;
  const Eigen::JacobiSVD<Mat3> svd(F, Eigen::ComputeFullU | Eigen::ComputeFullV);
  Mat3 U = svd.matrixU();
  if ((U * svd.matrixV().transpose()).determinant() < 0) U.col(2) *= -1;
  return U * svd.matrixV().transpose();
}

void PlainReference::addElement(std::size_t element, Eigen::VectorXd* b) {
  const double dt = scene_.solver.time_step;
  const std::array<int, 4>& nodes = mesh_.elements[element];
  const Mat3 R = rotation(element);
  Matrix12 R12 = Matrix12::Zero();
  Vector12 turned_back, v;  // Rᵀ x − X
  for (int I = 0; I < 4; ++I) {
    R12.block<3, 3>(3 * I, 3 * I) = R;
    turned_back.segment<3>(3 * I) = R.transpose() * x_[nodes[I]] - mesh_.nodes[nodes[I]];
    v.segment<3>(3 * I) = v_[nodes[I]];
  }
  const Matrix12 RK = R12 * elements_[element].stiffness;
  const Matrix12 K = RK * R12.transpose();
  const Vector12 force = RK * turned_back + dt * (K * v);
  for (int I = 0; I < 4; ++I)
    if (unknown_[nodes[I]] >= 0) b->segment<3>(unknown_[nodes[I]]) -= dt * force.segment<3>(3 * I);
  for (int i = 0, k = 0; i < 12; ++i)
    for (int j = 0; j <= i; ++j, ++k)
      if (const int slot = slots_[element][k]; slot >= 0) A_.valuePtr()[slot] += dt * dt * K(i, j);
}

void PlainReference::step() {
  const double dt = scene_.solver.time_step;
  Eigen::VectorXd b = Eigen::VectorXd::Zero(A_.rows());
  std::fill_n(A_.valuePtr(), A_.nonZeros(), 0.0);
  for (std::size_t n = 0; n < x_.size(); ++n) {
    if (unknown_[n] < 0) continue;
    b.segment<3>(unknown_[n]) = dt * masses_[n] * scene_.gravity;
    for (int i = 0; i < 3; ++i) A_.valuePtr()[A_.outerIndexPtr()[unknown_[n] + i]] = masses_[n];  // on the diagonal
  }
  for (std::size_t e = 0; e < elements_.size(); ++e) addElement(e, &b);

  cholmod_.factorize(A_);
  if (cholmod_.info() != Eigen::Success) throw std::runtime_error("the plain reference could not factorise its matrix");
  const Eigen::VectorXd dv = cholmod_.solve(b);
  for (std::size_t n = 0; n < x_.size(); ++n) {
    if (unknown_[n] < 0) continue;
    v_[n] += dv.segment<3>(unknown_[n]);
    x_[n] += dt * v_[n];
  }
}

}  // namespace incision::bench
