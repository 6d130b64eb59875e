#include "incision/fem/assembly.h"

#include <algorithm>
#include <array>
#include <limits>

#include "incision/fem/parallel.h"
#include "incision/fem/rotation.h"

namespace incision {
namespace {

/// Roundings that add up in one force: of four products in F, three each in RᵀF, σ, Rσ and the force itself.
constexpr double ROUNDINGS = 16;

}  // namespace

Assembly::Assembly(const CutMesh& mesh, const Material& material, Mass mass, bool warping, int threads)
    : mesh_(mesh),
      material_(material),
      mass_(mass),
      warping_(warping),
      threads_(threads),
      rest_(restElements(mesh.mesh())) {
  // Room for cuts, or the first one would move these arrays, the largest but for the matrix.
  const std::size_t expected = mesh.parts().size() + mesh.parts().size() / 4;
  rotations_.reserve(expected);
  part_forces_.reserve(expected);
  corners_.reserve(4 * expected);
}

void Assembly::topologyChanged(const std::vector<Vec3>& x) {
  const std::vector<Part>& parts = mesh_.parts();
  const int copies = mesh_.numCopies();
  part_forces_.resize(parts.size());
  masses_.assign(copies, 0);
  corner_start_.assign(copies + 1, 0);
  for (std::size_t p = 0; p < parts.size(); ++p) {
    const Barycentric N = mesh_.centroid(static_cast<int>(p));
    for (int I = 0; I < 4; ++I) {
      masses_[parts[p].copies[I]] += material_.density * volume(static_cast<int>(p)) * N[I];
      ++corner_start_[parts[p].copies[I] + 1];
    }
  }
  for (int c = 0; c < copies; ++c) corner_start_[c + 1] += corner_start_[c];
  corners_.resize(corner_start_.back());
  std::vector<int> end(corner_start_.begin(), corner_start_.end() - 1);
  for (std::size_t p = 0; p < parts.size(); ++p)
    for (int I = 0; I < 4; ++I) corners_[end[parts[p].copies[I]]++] = {static_cast<int>(p), I};

  const std::size_t known = rotations_.size();
  rotations_.resize(parts.size(), Mat3::Identity());
  if (!warping_) return;
  for (std::size_t p = known; p < parts.size(); ++p)
    rotations_[p] = polarRotation(gradientOf(static_cast<int>(p), x), rotations_[parts[p].element]);
}

void Assembly::rotate(const std::vector<Vec3>& x) {
  if (!warping_) return;
  const int parts = static_cast<int>(rotations_.size());
  parallelFor((parts + LANES - 1) / LANES, threads_, [&](int group) {
    const int first = LANES * group;
    std::array<Mat3, LANES> F, R;
    for (int l = 0; l < LANES; ++l) {
      const int p = std::min(first + l, parts - 1);  // the last one fills up its group
      F[l] = gradientOf(p, x);
      R[l] = rotations_[p];
    }
    polarRotations(F.data(), R.data());
    for (int p = first; p < std::min(first + LANES, parts); ++p) rotations_[p] = R[p - first];
  });
}

void Assembly::resetRotations() { rotations_.assign(rotations_.size(), Mat3::Identity()); }

// K_e is V_e Bᵀ D B, and B acts on R_pᵀ y − X through its gradient R_pᵀ F − I alone: the force on node I is V_p R σ
// b_I.
void Assembly::elasticForces(const std::vector<Vec3>& y, std::vector<Vec3>* forces) const {
  parallelFor(static_cast<int>(mesh_.parts().size()), threads_, [&](int p) {
    const Mat3& R = rotations_[p];
    const Mat3 stress = corotatedStress(R.transpose() * gradientOf(p, y), material_);
    part_forces_[p].noalias() = (volume(p) * R * stress) * rest_[mesh_.parts()[p].element].b;
  });
  gather(forces);
}

// F is a sum of y_J b_Jᵀ that mostly cancel: its rounding is that of the largest, and the stress carries it on.
std::vector<double> Assembly::forceRounding() const {
  const double modulus = material_.lambda() + 2 * material_.mu();
  std::vector<double> rounding(masses_.size(), 0);
  for (std::size_t p = 0; p < mesh_.parts().size(); ++p) {
    const Gradients& b = rest_[mesh_.parts()[p].element].b;
    const double stress = ROUNDINGS * std::numeric_limits<double>::epsilon() * modulus * b.colwise().norm().maxCoeff();
    for (int I = 0; I < 4; ++I)
      rounding[mesh_.parts()[p].copies[I]] += volume(static_cast<int>(p)) * b.col(I).norm() * stress;
  }
  return rounding;
}

void Assembly::multiplyMass(const std::vector<Vec3>& w, std::vector<Vec3>* result) const {
  if (!consistentMass()) {
    result->resize(w.size());
    parallelFor(static_cast<int>(w.size()), threads_, [&](int c) { (*result)[c] = masses_[c] * w[c]; });
    return;
  }
  parallelFor(static_cast<int>(mesh_.parts().size()), threads_, [&](int p) {
    part_forces_[p].setZero();
    for (int I = 0; I < 4; ++I)
      for (int J = 0; J < 4; ++J) part_forces_[p].col(I) += massProduct(p, I, J) * w[mesh_.parts()[p].copies[J]];
  });
  gather(result);
}

void Assembly::gather(std::vector<Vec3>* result) const {
  result->resize(masses_.size());
  parallelFor(static_cast<int>(masses_.size()), threads_, [&](int c) {
    Vec3 sum = Vec3::Zero();
    for (int k = corner_start_[c]; k < corner_start_[c + 1]; ++k)
      sum += part_forces_[corners_[k].part].col(corners_[k].node);
    (*result)[c] = sum;
  });
}

Mat3 Assembly::rotationAt(int part, const Mat3& F) const {
  return warping_ ? polarRotation(F, rotations_[part]) : Mat3::Identity();
}

double Assembly::elasticEnergy(const std::vector<Vec3>& x) const {
  double energy = 0;
  for (std::size_t p = 0; p < mesh_.parts().size(); ++p) {
    const int part = static_cast<int>(p);
    const Mat3 F = gradientOf(part, x), RtF = rotationAt(part, F).transpose() * F;
    const Mat3 strain = 0.5 * (RtF + RtF.transpose()) - Mat3::Identity();
    energy += 0.5 * volume(part) * corotatedStress(RtF, material_).cwiseProduct(strain).sum();
  }
  return energy;
}

Mat3 Assembly::stress(int part, const std::vector<Vec3>& x) const {
  const Mat3 F = gradientOf(part, x), R = rotationAt(part, F);
  return R * corotatedStress(R.transpose() * F, material_) * R.transpose();
}

double Assembly::volume(int part) const {
  return mesh_.parts()[part].fraction * rest_[mesh_.parts()[part].element].volume;
}

Gradients Assembly::rotatedGradients(int part) const { return rotations_[part] * rest_[mesh_.parts()[part].element].b; }

double Assembly::massProduct(int part, int I, int J) const {
  const double element_mass = material_.density * rest_[mesh_.parts()[part].element].volume;
  if (mesh_.parts()[part].detail < 0) return element_mass * (I == J ? 2 : 1) / 20;
  return element_mass * mesh_.detail(part).products(I, J);
}

Mat3 Assembly::gradientOf(int part, const std::vector<Vec3>& y) const {
  const Part& p = mesh_.parts()[part];
  return gradient(y[p.copies[0]], y[p.copies[1]], y[p.copies[2]], y[p.copies[3]], rest_[p.element].b);
}

}  // namespace incision
