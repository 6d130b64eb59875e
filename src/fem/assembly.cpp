#include "incision/fem/assembly.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numeric>
#include <utility>

#include "incision/base/parallel.h"
#include "lanes.h"

namespace incision {
namespace {

Corner corner(int part, int node) { return {static_cast<unsigned>(part), static_cast<unsigned>(node)}; }

/// Roundings that add up in one force: of four products in F, three each in RᵀF, σ, Rσ and the force itself.
constexpr double ROUNDINGS = 16;

}  // namespace

Assembly::Assembly(const CutMesh& mesh, const Materials& materials, Mass mass, Pressure pressure, bool warping,
                   int threads)
    : mesh_(mesh), materials_(materials), mass_(mass), warping_(warping), threads_(threads) {
  const std::vector<RestElement> rest = restElements(mesh.mesh());
  for (std::size_t e = 0; e < rest.size(); ++e) elements_.push_back({rest[e], materials.lame(static_cast<int>(e))});
  // Room for cuts, or the first one would move these arrays, the largest but for the matrix.
  const std::size_t expected = mesh.parts().size() + mesh.parts().size() / 4;
  rotations_.reserve(expected);
  if (warping) found_rotations_.reserve(expected);
  if (pressure == Pressure::AVERAGED) patches_.emplace(mesh, materials.regions());
}

void Assembly::topologyChanged(const std::vector<Vec3>& x, const std::vector<int>& touched) {
  found_at_.clear();
  const std::vector<Part>& parts = mesh_.parts();
  const bool first = corners_.count() == 0;
  std::vector<char> is_touched(mesh_.mesh().nodes.size(), first);
  for (int node : touched) is_touched[node] = 1;
  findCorners(is_touched);
  if (patches_) patches_->topologyChanged(touched);

  const int copies = mesh_.numCopies();
  for (auto* sums : {&masses_, &mass_diagonal_, &stiffness_diagonal_, &force_rounding_}) sums->resize(copies);
  parallelFor(copies, threads_, [&](int c) {
    if (is_touched[mesh_.copyNode(c)]) sumCorners(c);
  });

  run_sums_.topologyChanged(parts, copies);
  const std::size_t known = rotations_.size();
  rotations_.resize(parts.size(), Mat3::Identity());
  if (!warping_) return;
  for (std::size_t p = known; p < parts.size(); ++p)
    rotations_[p] = polarRotation(gradientOf(static_cast<int>(p), x), rotations_[parts[p].element]);
}

/// Lists the corners of every copy by ascending part; those of untouched nodes keep theirs.
void Assembly::findCorners(const std::vector<char>& touched) {
  const MeshTopology& topology = mesh_.topology();
  const int copies = mesh_.numCopies();
  Lists<Corner> sorted;
  sorted.sort(copies, [&](const auto& add) {
    for (int c = 0; c < copies; ++c) {
      if (touched[mesh_.copyNode(c)]) continue;
      for (const Corner& corner : corners_[c]) add(c, corner);
    }
    for (int n = 0; n < topology.star.count(); ++n) {
      if (!touched[n]) continue;
      for (int e : topology.star[n]) {
        const auto& nodes = mesh_.mesh().elements[e];
        const int I = static_cast<int>(std::find(nodes.begin(), nodes.end(), n) - nodes.begin());
        for (int p = e; p >= 0; p = mesh_.parts()[p].next) add(mesh_.parts()[p].copies[I], corner(p, I));
      }
    }
  });
  corners_ = std::move(sorted);
  for (int c = 0; c < copies; ++c)
    if (touched[mesh_.copyNode(c)])
      std::sort(corners_[c].begin(), corners_[c].end(),
                [](const Corner& a, const Corner& b) { return a.part < b.part; });
}

// The trace of K_cc is V_p (λ + 4 μ) b_I·b_I for each corner. The rounding of a force: F is a sum of y_J b_Jᵀ that
// mostly cancel, so it has that of the largest, and the stress carries it on.
void Assembly::sumCorners(int c) {
  masses_[c] = mass_diagonal_[c] = stiffness_diagonal_[c] = force_rounding_[c] = 0;
  for (const Corner& corner : corners_[c]) {
    const int p = corner.part, I = corner.node;
    const auto& [lambda, mu] = lameOf(p);
    const Gradients b = elements_[mesh_.parts()[p].element].gradients();
    const double V = volume(p), largest = std::sqrt(b.colwise().squaredNorm().maxCoeff());
    masses_[c] += densityOf(p) * V * mesh_.centroid(p)[I];
    mass_diagonal_[c] += massProduct(p, I, I);
    stiffness_diagonal_[c] += V * (lambda + 4 * mu) / 3 * b.col(I).squaredNorm();
    force_rounding_[c] +=
        ROUNDINGS * std::numeric_limits<double>::epsilon() * (lambda + 2 * mu) * V * b.col(I).norm() * largest;
  }
}

/// Calls f(p, F_p, R_p) for every part of a group of LANES, with the gradient and the rotation that belong to `x`.
template <typename Function>
void Assembly::turnGroup(int group, const std::vector<Vec3>& x, const Function& f) const {
  const int parts = static_cast<int>(rotations_.size()), first = LANES * group;
  std::array<Mat3, LANES> F, R;
  for (int l = 0; l < LANES; ++l) {
    const int p = std::min(first + l, parts - 1);  // the last one fills up its group
    F[l] = gradientOf(p, x);
    R[l] = rotations_[p];
  }
  if (warping_) polarRotations(F.data(), R.data());
  for (int p = first; p < std::min(first + LANES, parts); ++p) f(p, F[p - first], R[p - first]);
}

template <typename Function>
void Assembly::turnAll(const std::vector<Vec3>& x, const Function& f) const {
  parallelFor(groups(), threads_, [&](int group) { turnGroup(group, x, f); });
}

void Assembly::rotate(const std::vector<Vec3>& x) {
  if (!warping_) return;
  const bool any_found = found_at_ == x && found_rotations_.size() == rotations_.size();
  found_rotations_.resize(rotations_.size());
  parallelFor(groups(), threads_, [&](int group) {
    if (any_found && found_[group]) return;
    turnGroup(group, x, [&](int p, const Mat3&, const Mat3& R) { found_rotations_[p] = R; });
  });
  rotations_.swap(found_rotations_);
  rotated_ = true;
  found_at_.clear();
}

void Assembly::rotateOn(const std::vector<Vec3>& x) {
  if (warping_) turnAll(x, [&](int p, const Mat3&, const Mat3& R) { rotations_[p] = R; });
}

void Assembly::rotateBack() {
  if (warping_) rotations_.swap(found_rotations_);
  rotated_ = false;
}

void Assembly::markRotations() noexcept {
  rotated_ = false;
  marked_rotations_ = rotations_.size();
}

void Assembly::takeMarked(std::vector<Mat3>* marked) noexcept {
  if (rotated_) rotations_.swap(found_rotations_);
  rotated_ = false;
  marked->swap(rotations_);
  marked->resize(warping_ ? marked_rotations_ : 0);
  rotations_.clear();
}

const std::vector<Mat3>& Assembly::rotations() const {
  static const std::vector<Mat3> none;
  return warping_ ? rotations_ : none;
}

void Assembly::recallRotations(const std::vector<Mat3>& rotations) {
  found_at_.clear();
  if (!rotations.empty()) rotations_ = rotations;
}

void Assembly::reset() {
  rotations_.clear();
  found_at_.clear();
  if (patches_) patches_->reset();
  corners_.clear();
}

// K_e is V_e Bᵀ D B, and B acts on R_pᵀ y − X through its gradient R_pᵀ F − I alone: the force on node I is V_p R σ
// b_I, and the four sum to zero. With averaged pressure σ holds the mean dilatation θ_a of the part's patch, which is
// the derivative of Σ_p V_p μ ε:ε + Σ_a V_a ½ λ θ_a², as every θ_p goes into θ_a by its volume.
void Assembly::elasticForces(const std::vector<Vec3>& y, std::vector<Vec3>* forces) const {
  if (patches_) averageDilatations(y, [&](int p, const Mat3&) -> const Mat3& { return rotations_[p]; });
  parallelFor(run_sums_.runs(), threads_, [&](int run) {
    run_sums_.clear(run);
    const int parts = static_cast<int>(mesh_.parts().size()), end = std::min(parts, RunSums::RUN * (run + 1));
    for (int p = RunSums::RUN * run; p < end; p += LANES) addForces(p, std::min(LANES, end - p), y);
  });
  run_sums_.gather(forces, threads_);
}

/// Those of up to LANES parts go into their run's sums.
void Assembly::addForces(int first, int count, const std::vector<Vec3>& y) const {
  std::array<int, LANES> at;  // the last one fills up the lanes
  std::array<const TissueElement*, LANES> element;
  LaneMatrix D, b, R, F, RtF, stress, turned, f;
  Lanes lambda, mu, dilatation = Lanes();
  for (int l = 0; l < LANES; ++l) {
    at[l] = first + std::min(l, count - 1);
    const Part& part = mesh_.parts()[at[l]];
    element[l] = &elements_[part.element];
    const Vec3& y_0 = y[part.copies[0]];
    for (int J = 0; J < 3; ++J)
      for (int i = 0; i < 3; ++i) D[i][J][l] = y[part.copies[J + 1]][i] - y_0[i];
    const double V = part.fraction * element[l]->volume;
    lambda[l] = V * element[l]->lame.lambda;
    mu[l] = V * element[l]->lame.mu;
    if (patches_) dilatation[l] = mean_dilatations_[patches_->of(at[l])];
  }
  load([&](int l) -> const Mat3& { return element[l]->b; }, b);
  load([&](int l) -> const Mat3& { return rotations_[at[l]]; }, R);
  multiplyByTransposed(D, b, F);
  multiplyTransposed(R, F, RtF);
  for (int i = 0; i < 3; ++i)
    for (int j = 0; j < 3; ++j) stress[i][j] = mu * (RtF[i][j] + RtF[j][i] - (i == j ? 2.0 : 0.0));
  if (!patches_) dilatation = RtF[0][0] + RtF[1][1] + RtF[2][2] - 3.0;
  for (int i = 0; i < 3; ++i) stress[i][i] += lambda * dilatation;
  multiply(R, stress, turned);
  multiply(turned, b, f);
  for (int l = 0; l < count; ++l) {
    const std::array<Vec3*, 4> sums = {&run_sums_.at(at[l], 0), &run_sums_.at(at[l], 1), &run_sums_.at(at[l], 2),
                                       &run_sums_.at(at[l], 3)};
    for (int i = 0; i < 3; ++i) {
      for (int J = 0; J < 3; ++J) (*sums[J + 1])[i] += f[i][J][l];
      (*sums[0])[i] -= f[i][0][l] + f[i][1][l] + f[i][2][l];
    }
  }
}

/// θ_p = tr(R_pᵀ F_p) − 3 of every part, then θ_a = Σ V_p θ_p / V_a of every patch.
template <typename Rotation>
void Assembly::averageDilatations(const std::vector<Vec3>& y, const Rotation& rotationOf) const {
  dilatations_.resize(mesh_.parts().size());
  parallelFor(static_cast<int>(dilatations_.size()), threads_, [&](int p) {
    const Mat3 F = gradientOf(p, y);
    dilatations_[p] = rotationOf(p, F).cwiseProduct(F).sum() - 3;
  });
  mean_dilatations_.resize(patches_->count());
  parallelFor(patches_->count(), threads_, [&](int a) {
    double gained = 0;
    for (int p : patches_->parts()[a]) gained += volume(p) * dilatations_[p];
    mean_dilatations_[a] = gained / patchVolume(a);
  });
}

void Assembly::multiplyMass(const std::vector<Vec3>& w, std::vector<Vec3>* result) const {
  if (!consistentMass()) {
    result->resize(w.size());
    parallelFor(static_cast<int>(w.size()), threads_, [&](int c) { (*result)[c] = masses_[c] * w[c]; });
    return;
  }
  part_momenta_.resize(mesh_.parts().size());
  parallelFor(static_cast<int>(mesh_.parts().size()), threads_, [&](int p) {
    part_momenta_[p].setZero();
    for (int I = 0; I < 4; ++I)
      for (int J = 0; J < 4; ++J) part_momenta_[p].col(I) += massProduct(p, I, J) * w[mesh_.parts()[p].copies[J]];
  });
  gather([&](const Corner& corner) -> Vec3 { return part_momenta_[corner.part].col(corner.node); }, result);
}

/// Sums what the corners of every copy bring.
template <typename Function>
void Assembly::gather(const Function& atCorner, std::vector<Vec3>* result) const {
  result->resize(masses_.size());
  parallelFor(static_cast<int>(masses_.size()), threads_, [&](int c) {
    Vec3 sum = Vec3::Zero();
    for (const Corner& corner : corners_[c]) sum += atCorner(corner);
    (*result)[c] = sum;
  });
}

Mat3 Assembly::rotationAt(int part, const Mat3& F) const {
  return warping_ ? polarRotation(F, rotations_[part]) : Mat3::Identity();
}

double Assembly::elasticEnergy(const std::vector<Vec3>& x) const {
  const std::size_t parts = mesh_.parts().size();
  if (patches_) {
    std::vector<Mat3> turned(parts);
    turnAll(x, [&](int p, const Mat3&, const Mat3& R) { turned[p] = R; });
    averageDilatations(x, [&](int p, const Mat3&) -> const Mat3& { return turned[p]; });
  }
  std::vector<double> energies(parts);
  turnAll(x, [&](int p, const Mat3& F, const Mat3& R) {
    const Mat3 RtF = R.transpose() * F;
    energies[p] = 0.5 * volume(p) * stressOf(p, RtF, lameOf(p)).cwiseProduct(corotatedStrain(RtF)).sum();
  });
  return std::accumulate(energies.begin(), energies.end(), 0.0);
}

Mat3 Assembly::stress(int part, const std::vector<Vec3>& x) const {
  const Mat3 F = gradientOf(part, x), R = rotationAt(part, F);
  if (!patches_) return R * corotatedStress(R.transpose() * F, lameOf(part)) * R.transpose();
  double gained = 0;
  const int a = patches_->of(part);
  for (int p : patches_->parts()[a]) {
    const Mat3 F_p = gradientOf(p, x);
    gained += volume(p) * (rotationAt(p, F_p).cwiseProduct(F_p).sum() - 3);
  }
  return R * corotatedStress(R.transpose() * F, gained / patchVolume(a), lameOf(part)) * R.transpose();
}

void Assembly::stresses(const std::vector<Vec3>& x, std::vector<Mat3>* stress) const {
  stressesOfGroups(
      x, [](int) { return true; }, stress);
}

// The mean dilatations need those of all parts.
void Assembly::stresses(const std::vector<Vec3>& x, const std::vector<char>& wanted, std::vector<Mat3>* stress) const {
  if (patches_) return stresses(x, stress);
  const auto isWanted = [&](int group) {
    const int first = LANES * group, end = std::min(first + LANES, static_cast<int>(wanted.size()));
    return std::find(wanted.begin() + first, wanted.begin() + end, 1) != wanted.begin() + end;
  };
  stressesOfGroups(x, isWanted, stress);
}

/// A group is turned as a whole, since the rotations it finds differ in last digits with what is found together.
template <typename Wanted>
void Assembly::stressesOfGroups(const std::vector<Vec3>& x, const Wanted& isWanted, std::vector<Mat3>* stress) const {
  stress->resize(rotations_.size());
  found_rotations_.resize(rotations_.size());
  found_at_ = x;
  found_.resize(groups());
  parallelFor(groups(), threads_, [&](int group) {
    found_[group] = isWanted(group);
    if (!found_[group]) return;
    turnGroup(group, x, [&](int p, const Mat3& F, const Mat3& R) {
      found_rotations_[p] = R;
      const Mat3 RtF = R.transpose() * F;
      const Lame& lame = lameOf(p);
      (*stress)[p] = R * (patches_ ? corotatedStress(RtF, 0, lame) : corotatedStress(RtF, lame)) * R.transpose();
    });
  });
  if (!patches_) return;
  averageDilatations(x, [&](int p, const Mat3&) -> const Mat3& { return found_rotations_[p]; });
  parallelFor(static_cast<int>(stress->size()), threads_,
              [&](int p) { (*stress)[p].diagonal().array() += lameOf(p).lambda * mean_dilatations_[patches_->of(p)]; });
}

double Assembly::volume(int part) const {
  return mesh_.parts()[part].fraction * elements_[mesh_.parts()[part].element].volume;
}

double Assembly::patchVolume(int patch) const {
  double sum = 0;
  for (int p : patches_->parts()[patch]) sum += volume(p);
  return sum;
}

Gradients Assembly::rotatedGradients(int part) const {
  return rotations_[part] * elements_[mesh_.parts()[part].element].gradients();
}

double Assembly::massProduct(int part, int I, int J) const {
  const double element_mass = densityOf(part) * elements_[mesh_.parts()[part].element].volume;
  if (mesh_.parts()[part].detail < 0) return element_mass * (I == J ? 2 : 1) / 20;
  return element_mass * mesh_.detail(part).products(I, J);
}

Mat3 Assembly::gradientOf(int part, const std::vector<Vec3>& y) const {
  const Part& p = mesh_.parts()[part];
  return gradient(y[p.copies[0]], y[p.copies[1]], y[p.copies[2]], y[p.copies[3]], elements_[p.element]);
}

}  // namespace incision
