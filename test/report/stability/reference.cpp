#include "reference.h"

#include <Eigen/LU>
#include <Eigen/SVD>
#include <algorithm>
#include <cmath>
#include <limits>

namespace incision::report {
namespace {

using Real = long double;
using Vector = Eigen::Matrix<Real, 3, 1>;
using Matrix = Eigen::Matrix<Real, 3, 3>;
using Corners = Eigen::Matrix<Real, 3, 4>;  // a column for each of a part's four copies

/// Products and sums behind one force, each of them rounded in double.
constexpr Real ROUNDINGS = 16 * std::numeric_limits<double>::epsilon();

/// An element at rest.
struct Rest {
  Corners nodes, gradients;
  Real volume;
};

Rest restOf(const TetMesh& mesh, int element) {
  Rest rest;
  for (int I = 0; I < 4; ++I) rest.nodes.col(I) = mesh.nodes[mesh.elements[element][I]].cast<Real>();
  const Matrix Dm = rest.nodes.rightCols<3>().colwise() - rest.nodes.col(0);
  rest.volume = Dm.determinant() / 6;
  rest.gradients.rightCols<3>() = Dm.inverse().transpose();
  rest.gradients.col(0) = -rest.gradients.rightCols<3>().rowwise().sum();
  return rest;
}

Matrix properRotation(const Matrix& F) {
  const Eigen::JacobiSVD<Matrix> svd(F, Eigen::ComputeFullU | Eigen::ComputeFullV);
  Matrix U = svd.matrixU();
  if ((U * svd.matrixV().transpose()).determinant() < 0) U.col(2) = -U.col(2);
  return U * svd.matrixV().transpose();
}

Corners atCopies(const std::vector<Vec3>& values, const Part& part) {
  Corners corners;
  for (int I = 0; I < 4; ++I) corners.col(I) = values[part.copies[I]].cast<Real>();
  return corners;
}

/// V R σ(u) b_I for each copy I, where u = Rᵀ y − X, or Rᵀ y of a velocity.
Corners elasticForce(const Corners& u, const Matrix& R, const Rest& rest, Real volume, const Material& material) {
  const Matrix H = u * rest.gradients.transpose(), strain = (H + H.transpose()) / 2;
  const Matrix stress = material.lambda() * strain.trace() * Matrix::Identity() + 2 * material.mu() * strain;
  return volume * R * stress * rest.gradients;
}

/// What the parts bring to each copy.
struct Sums {
  explicit Sums(std::size_t copies)
      : right(copies, Vector::Zero()), left(right), mass(copies, 0), diagonal(mass), rounding(mass) {}
  std::vector<Vector> right, left;
  std::vector<Real> mass, diagonal, rounding;
};

/// Adds what a part brings to both sides; Δt C + Δt² K holds factor K.
void addPart(const Rig& rig, const RigSettings& settings, const Motion& before, const std::vector<Vec3>& dv, Real reach,
             int p, Sums* sums) {
  const Material& material = settings.material;
  const Real dt = rig.time_step, alpha = material.mass_damping, beta = material.stiffness_damping,
             factor = dt * (dt + beta);
  const Part& part = rig.mesh.parts()[p];
  const Rest rest = restOf(rig.mesh.mesh(), part.element);
  const Real volume = part.fraction * rest.volume;
  const Corners x = atCopies(before.x, part), v = atCopies(before.v, part), added = atCopies(dv, part);
  const Matrix R = settings.warping ? properRotation(x * rest.gradients.transpose()) : Matrix::Identity();
  const Corners inner = elasticForce(R.transpose() * x - rest.nodes, R, rest, volume, material);
  const Corners along_v = elasticForce(R.transpose() * v, R, rest, volume, material);
  const Corners along_dv = elasticForce(R.transpose() * added, R, rest, volume, material);
  const Real largest = std::sqrt(rest.gradients.colwise().squaredNorm().maxCoeff());
  const Real lambda = material.lambda(), mu = material.mu();
  for (int I = 0; I < 4; ++I) {
    const int c = part.copies[I];
    const Real m = material.density * volume * rig.mesh.centroid(p)[I], b = rest.gradients.col(I).norm();
    sums->mass[c] += m;
    sums->right[c] += dt * m * (settings.conditions.gravity.cast<Real>() - alpha * v.col(I)) - dt * inner.col(I) -
                      factor * along_v.col(I);
    sums->left[c] += (1 + alpha * dt) * m * added.col(I) + factor * along_dv.col(I);
    sums->diagonal[c] += (1 + alpha * dt) * m + factor * volume * (lambda + 4 * mu) / 3 * b * b;
    sums->rounding[c] += dt * ROUNDINGS * reach * volume * (lambda + 2 * mu) * b * largest;
  }
}

/// Squared norms over a piece, or the body.
struct Norms {
  Real residual = 0, right = 0, rounding = 0, mass = 0;
  void add(const Sums& sums, std::size_t c) {
    residual += (sums.right[c] - sums.left[c]).squaredNorm() / sums.diagonal[c];
    right += sums.right[c].squaredNorm() / sums.diagonal[c];
    rounding += sums.rounding[c] * sums.rounding[c] / sums.diagonal[c];
    mass += sums.mass[c];
  }
};

}  // namespace

StepResidual stepResidual(const Rig& rig, const RigSettings& settings, const Motion& before, double tolerance) {
  const std::size_t copies = before.x.size();
  const double beta = settings.material.stiffness_damping;
  std::vector<Vec3> dv = rig.motion.v;
  Real reach = 0;
  for (std::size_t c = 0; c < copies; ++c) {
    dv[c] -= before.v[c];
    const Vec3 way = (rig.time_step + beta) * before.v[c].cwiseAbs().cwiseMax(rig.motion.v[c].cwiseAbs());
    reach = std::max<Real>({reach, before.x[c].cwiseAbs().maxCoeff(), way.maxCoeff()});
  }
  Sums sums(copies);
  for (int p = 0; p < static_cast<int>(rig.mesh.parts().size()); ++p)
    addPart(rig, settings, before, dv, reach, p, &sums);

  Norms whole;
  std::vector<Norms> pieces(rig.step.pieces());
  for (std::size_t c = 0; c < copies; ++c) {
    if (rig.step.held()[c] >= 0) continue;
    whole.add(sums, c);
    pieces[rig.step.pieceOf()[c]].add(sums, c);
  }
  if (!(whole.right > 0)) return {};
  StepResidual result;
  result.relative = static_cast<double>(std::sqrt(whole.residual / whole.right));
  for (const Norms& piece : pieces) {
    if (!(piece.mass > 0)) continue;
    const Real measure = std::max(piece.right, piece.mass / whole.mass * whole.right);
    const Real asked = tolerance * std::sqrt(measure) + std::sqrt(piece.rounding);
    result.share = std::max(result.share, static_cast<double>(std::sqrt(piece.residual) / asked));
  }
  return result;
}

}  // namespace incision::report
