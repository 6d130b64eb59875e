// What the parts' rotations give: forces, energy and stress.
#include <algorithm>
#include <array>
#include <numeric>

#include "incision/base/parallel.h"
#include "incision/fem/assembly.h"
#include "stress_lanes.h"

namespace incision {

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

// K_e is V_e Bᵀ D B, and B acts on R_pᵀ y − X through its gradient R_pᵀ F − I alone: the force on node I is V_p R σ
// b_I, and the four sum to zero. With averaged pressure σ holds the mean dilatation θ_a of the part's patch, which is
// the derivative of Σ_p V_p μ ε:ε + Σ_a V_a ½ λ θ_a², as every θ_p goes into θ_a by its volume.
void Assembly::elasticForces(const std::vector<Vec3>& y, std::vector<Vec3>* forces) const {
  if (patches_) averageDilatations(y);
  parallelFor(run_sums_.runs(), threads_, [&](int run) {
    run_sums_.clear(run);
    const int parts = static_cast<int>(mesh_.parts().size()), end = std::min(parts, RunSums::RUN * (run + 1));
    for (int p = RunSums::RUN * run; p < end; p += LANES) addForces(p, std::min(LANES, end - p), y);
  });
  run_sums_.gather(forces, threads_);
}

/// That of up to LANES parts with the rotations that they have. With averaged pressure the mean dilatations must be
/// those at y.
void Assembly::findStress(int first, int count, const std::vector<Vec3>& y, StressLanes& lanes) const {
  std::array<const TissueElement*, LANES> element;
  LaneMatrix D, F, RtF;
  Lanes lambda, mu, dilatation = Lanes();
  for (int l = 0; l < LANES; ++l) {
    lanes.at[l] = first + std::min(l, count - 1);
    const Part& part = mesh_.parts()[lanes.at[l]];
    element[l] = &elements_[part.element];
    const Vec3& y_0 = y[part.copies[0]];
    for (int J = 0; J < 3; ++J)
      for (int i = 0; i < 3; ++i) D[i][J][l] = y[part.copies[J + 1]][i] - y_0[i];
    const double V = part.fraction * element[l]->volume;
    lambda[l] = V * element[l]->lame.lambda;
    mu[l] = V * element[l]->lame.mu;
    if (patches_) dilatation[l] = mean_dilatations_[patches_->of(lanes.at[l])];
  }
  load([&](int l) -> const Mat3& { return element[l]->b; }, lanes.b);
  load([&](int l) -> const Mat3& { return rotations_[lanes.at[l]]; }, lanes.R);
  multiplyByTransposed(D, lanes.b, F);
  multiplyTransposed(lanes.R, F, RtF);
  for (int i = 0; i < 3; ++i)
    for (int j = 0; j < 3; ++j) lanes.stress[i][j] = mu * (RtF[i][j] + RtF[j][i] - (i == j ? 2.0 : 0.0));
  if (!patches_) dilatation = RtF[0][0] + RtF[1][1] + RtF[2][2] - 3.0;
  for (int i = 0; i < 3; ++i) lanes.stress[i][i] += lambda * dilatation;
}

/// Those of up to LANES parts go into their run's sums.
void Assembly::addForces(int first, int count, const std::vector<Vec3>& y) const {
  StressLanes lanes;
  findStress(first, count, y, lanes);
  LaneMatrix turned, f;
  multiply(lanes.R, lanes.stress, turned);
  multiply(turned, lanes.b, f);
  for (int l = 0; l < count; ++l) {
    const int p = lanes.at[l];
    const std::array<Vec3*, 4> sums = {&run_sums_.at(p, 0), &run_sums_.at(p, 1), &run_sums_.at(p, 2),
                                       &run_sums_.at(p, 3)};
    for (int i = 0; i < 3; ++i) {
      for (int J = 0; J < 3; ++J) (*sums[J + 1])[i] += f[i][J][l];
      (*sums[0])[i] -= f[i][0][l] + f[i][1][l] + f[i][2][l];
    }
  }
}

/// With the rotations that there are.
void Assembly::averageDilatations(const std::vector<Vec3>& y) const {
  averageDilatations(y, [&](int p, const Mat3&) -> const Mat3& { return rotations_[p]; });
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

/// That of a part in its own frame.
template <typename Rotation>
Mat3 Assembly::stressUnder(int part, const std::vector<Vec3>& x, const Rotation& rotationOf) const {
  const Mat3 F = gradientOf(part, x), RtF = rotationOf(part, F).transpose() * F;
  if (!patches_) return corotatedStress(RtF, lameOf(part));
  double gained = 0;
  const int a = patches_->of(part);
  for (int p : patches_->parts()[a]) {
    const Mat3 F_p = gradientOf(p, x);
    gained += volume(p) * (rotationOf(p, F_p).cwiseProduct(F_p).sum() - 3);
  }
  return corotatedStress(RtF, gained / patchVolume(a), lameOf(part));
}

Mat3 Assembly::unrotatedStress(int part, const std::vector<Vec3>& x) const {
  return stressUnder(part, x, [&](int p, const Mat3&) -> const Mat3& { return rotations_[p]; });
}

Mat3 Assembly::stress(int part, const std::vector<Vec3>& x) const {
  const Mat3 R = rotationAt(part, gradientOf(part, x));
  return R * stressUnder(part, x, [&](int p, const Mat3& F) { return p == part ? R : rotationAt(p, F); }) *
         R.transpose();
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

Mat3 Assembly::gradientOf(int part, const std::vector<Vec3>& y) const {
  const Part& p = mesh_.parts()[part];
  return gradient(y[p.copies[0]], y[p.copies[1]], y[p.copies[2]], y[p.copies[3]], elements_[p.element]);
}

}  // namespace incision
