#include "reference.h"

#include <Eigen/Eigenvalues>
#include <Eigen/LU>
#include <Eigen/SVD>
#include <algorithm>
#include <cmath>
#include <limits>

#include "rigid_reference.h"

namespace incision::report {
namespace {

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
  const RealMat Dm = rest.nodes.rightCols<3>().colwise() - rest.nodes.col(0);
  rest.volume = Dm.determinant() / 6;
  rest.gradients.rightCols<3>() = Dm.inverse().transpose();
  rest.gradients.col(0) = -rest.gradients.rightCols<3>().rowwise().sum();
  return rest;
}

RealMat properRotation(const RealMat& F) {
  const Eigen::JacobiSVD<RealMat> svd(F, Eigen::ComputeFullU | Eigen::ComputeFullV);
  RealMat U = svd.matrixU();
  if ((U * svd.matrixV().transpose()).determinant() < 0) U.col(2) = -U.col(2);
  return U * svd.matrixV().transpose();
}

Corners atCopies(const std::vector<RealVec>& values, const Part& part) {
  Corners corners;
  for (int I = 0; I < 4; ++I) corners.col(I) = values[part.copies[I]];
  return corners;
}

/// σ(u) of what the copies have.
RealMat stressOf(const Corners& u, const Rest& rest, const Material& material) {
  const RealMat H = u * rest.gradients.transpose(), strain = (H + H.transpose()) / 2;
  return material.lambda() * strain.trace() * RealMat::Identity() + 2 * material.mu() * strain;
}

/// V R σ(u) b_I for each copy I, where u = Rᵀ y − X, or Rᵀ y of a velocity.
Corners elasticForce(const Corners& u, const RealMat& R, const Rest& rest, Real volume, const Material& material) {
  return volume * R * stressOf(u, rest, material) * rest.gradients;
}

/// V (b_I · S⁺ b_J) y_J for each copy I, S⁺ being the positive part of the stress of Rᵀ x − X.
Corners tensionForce(const Corners& y, const Corners& u, const Rest& rest, Real volume, const Material& material) {
  const Eigen::SelfAdjointEigenSolver<RealMat> axes(stressOf(u, rest, material));
  const RealMat positive =
      axes.eigenvectors() * axes.eigenvalues().cwiseMax(0).asDiagonal() * axes.eigenvectors().transpose();
  return volume * y * rest.gradients.transpose() * positive * rest.gradients;
}

/// ∫ ρ N_I of each copy.
std::vector<Real> massesOf(const Rig& rig, const Material& material) {
  std::vector<Real> mass(rig.motion.x.size(), 0);
  const TetMesh& mesh = rig.mesh.mesh();
  for (int p = 0; p < static_cast<int>(rig.mesh.parts().size()); ++p) {
    const Part& part = rig.mesh.parts()[p];
    const Real m = material.density * part.fraction * restOf(mesh, part.element).volume;
    for (int I = 0; I < 4; ++I) mass[part.copies[I]] += m * rig.mesh.centroid(p)[I];
  }
  return mass;
}

/// Both sides at each copy, and what goes with them.
struct Sides {
  explicit Sides(std::size_t copies)
      : right(copies, RealVec::Zero()), left(right), diagonal(copies, 0), rounding(diagonal) {}
  std::vector<RealVec> right, left;
  std::vector<Real> diagonal, rounding;
};

/// What is given of a step.
struct Given {
  const Rig& rig;
  const RigSettings& settings;
  const std::vector<Real>& mass;
  const ReferenceBase& base;
  const std::vector<RealVec>& dv;
  Real reach;
};

/// What the mass of a copy brings to both sides.
void addInertia(const Given& given, std::size_t c, Sides* sides) {
  const Real dt = given.rig.time_step, alpha = given.settings.material.mass_damping, m = given.mass[c];
  const RealVec g = given.settings.conditions.gravity.cast<Real>();
  sides->right[c] += dt * m * (g - alpha * (given.base.v[c] + given.base.u[c]));
  sides->left[c] += (1 + alpha * dt) * m * given.dv[c];
  sides->diagonal[c] += (1 + alpha * dt) * m;
}

/// What the stiffness of a part brings; Δt β K + Δt² K holds factor K.
void addStiffness(const Given& given, int p, Sides* sides) {
  const Material& material = given.settings.material;
  const Real dt = given.rig.time_step, factor = dt * (dt + material.stiffness_damping);
  const Part& part = given.rig.mesh.parts()[p];
  const Rest rest = restOf(given.rig.mesh.mesh(), part.element);
  const Real volume = part.fraction * rest.volume;
  const Corners x = atCopies(given.base.x, part);
  const RealMat R = given.settings.warping ? properRotation(x * rest.gradients.transpose()) : RealMat::Identity();
  const auto force = [&](const Corners& u) { return elasticForce(u, R, rest, volume, material); };
  const Corners inner = force(R.transpose() * x - rest.nodes);
  const Corners along_u = force(R.transpose() * atCopies(given.base.u, part));
  const Corners along_dv = force(R.transpose() * atCopies(given.dv, part));
  Corners pull_u = Corners::Zero(), pull_dv = pull_u;
  if (given.rig.step.tension().actsIn(p)) {
    const Corners strained = R.transpose() * x - rest.nodes;
    pull_u = dt * dt * tensionForce(atCopies(given.base.u, part), strained, rest, volume, material);
    pull_dv = dt * dt * tensionForce(atCopies(given.dv, part), strained, rest, volume, material);
  }
  const Real largest = std::sqrt(rest.gradients.colwise().squaredNorm().maxCoeff());
  const Real lambda = material.lambda(), mu = material.mu();
  for (int I = 0; I < 4; ++I) {
    const int c = part.copies[I];
    const Real b = rest.gradients.col(I).norm();
    sides->right[c] -= dt * inner.col(I) + factor * along_u.col(I) + pull_u.col(I);
    sides->left[c] += factor * along_dv.col(I) + pull_dv.col(I);
    sides->diagonal[c] += factor * volume * (lambda + 4 * mu) / 3 * b * b;
    sides->rounding[c] +=
        dt * ROUNDINGS * (given.reach + given.base.turned[c]) * volume * (lambda + 2 * mu) * b * largest;
  }
}

/// Squared norms over a piece, or the body.
struct Norms {
  Real residual = 0, right = 0, loads = 0, rounding = 0, mass = 0;
  Real acting() const { return std::max(right, loads); }
};

}  // namespace

StepResidual stepResidual(const Rig& rig, const RigSettings& settings, const Motion& before, double tolerance) {
  const std::size_t copies = before.x.size();
  const Real dt = rig.time_step, beta = settings.material.stiffness_damping;
  const std::vector<Real> mass = massesOf(rig, settings.material);
  const ReferenceBase base = rigidReference(rig, before, mass);
  std::vector<RealVec> dv(copies);
  Real reach = 0, places = 0;
  for (std::size_t c = 0; c < copies; ++c) {
    const RealVec v = rig.motion.v[c].cast<Real>();
    dv[c] = v - base.v[c] - base.u[c];
    const RealVec way = (dt + beta) * before.v[c].cast<Real>().cwiseAbs().cwiseMax(v.cwiseAbs());
    reach = std::max({reach, before.x[c].cast<Real>().cwiseAbs().maxCoeff(), way.maxCoeff()});
    places = std::max({places, base.x[c].cwiseAbs().maxCoeff(), dt * v.cwiseAbs().maxCoeff()});
  }

  const Given given{rig, settings, mass, base, dv, reach};
  Sides sides(copies);
  for (std::size_t c = 0; c < copies; ++c) addInertia(given, c, &sides);
  for (int p = 0; p < static_cast<int>(rig.mesh.parts().size()); ++p) addStiffness(given, p, &sides);

  Real off_place = 0;
  for (std::size_t c = 0; c < copies; ++c) {
    const RealVec place = base.x[c] + dt * (rig.motion.v[c].cast<Real>() - base.v[c]);
    const Real off = (rig.motion.x[c].cast<Real>() - place).cwiseAbs().maxCoeff();
    off_place = std::max(off_place, off / (ROUNDINGS * (places + base.turned[c])));
  }

  std::vector<Norms> pieces(rig.step.pieces());
  const RealVec weight = dt * settings.conditions.gravity.cast<Real>();
  for (std::size_t c = 0; c < copies; ++c) {
    if (rig.step.held()[c] >= 0) continue;
    Norms& piece = pieces[rig.step.pieceOf()[c]];
    piece.residual += (sides.right[c] - sides.left[c]).squaredNorm() / sides.diagonal[c];
    piece.right += sides.right[c].squaredNorm() / sides.diagonal[c];
    piece.loads += (mass[c] * weight).squaredNorm() / sides.diagonal[c];
    piece.rounding += sides.rounding[c] * sides.rounding[c] / sides.diagonal[c];
    piece.mass += mass[c];
  }
  Real acting = 0, residual = 0, all = 0;
  for (const Norms& piece : pieces) {
    acting += piece.acting();
    residual += piece.residual;
    all += piece.mass;
  }
  StepResidual result;
  result.off_place = static_cast<double>(off_place);
  if (!(acting > 0)) return result;
  result.relative = static_cast<double>(std::sqrt(residual / acting));
  for (const Norms& piece : pieces) {
    if (!(piece.mass > 0)) continue;
    const Real asked =
        tolerance * std::sqrt(std::max(piece.acting(), piece.mass / all * acting)) + std::sqrt(piece.rounding);
    result.share = std::max(result.share, static_cast<double>(std::sqrt(piece.residual) / asked));
  }
  return result;
}

}  // namespace incision::report
