#include "incision/solver/piece_norms.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace incision {
namespace {

/// How much of the tolerance the rounding of a float product may take up.
constexpr double ROUNDING_SHARE = 0.1;

}  // namespace

void PieceNorms::systemChanged(const Assembly& assembly, const SystemFactors& factors, const std::vector<int>& held,
                               const std::vector<int>& piece, int pieces) {
  piece_ = piece;
  squared_scale_.assign(piece.size(), 0);
  mass_.assign(static_cast<std::size_t>(pieces), 0);
  rounding_ = mass_;
  for (std::size_t c = 0; c < piece.size(); ++c) {
    if (held[c] >= 0) continue;
    squared_scale_[c] = 1 / diagonalOf(assembly, factors, static_cast<int>(c));
    mass_[piece[c]] += assembly.masses()[c];
    rounding_[piece[c]] += squared_scale_[c] * assembly.forceRounding()[c] * assembly.forceRounding()[c];
  }
}

void PieceNorms::squares(const std::vector<Vec3>& values, std::vector<double>* sums) const {
  sums->assign(mass_.size(), 0);
  for (std::size_t c = 0; c < piece_.size(); ++c) (*sums)[piece_[c]] += squared_scale_[c] * values[c].squaredNorm();
}

void PieceNorms::measure(const std::vector<Vec3>& b, const std::vector<Vec3>& loads, double reach, double tolerance) {
  squares(b, &measure_);
  squares(loads, &sum_);
  double whole = 0, mass = 0;
  bool any_loads = false;
  for (std::size_t s = 0; s < mass_.size(); ++s) {
    measure_[s] = std::max(measure_[s], sum_[s]);
    whole += measure_[s];
    mass += mass_[s];
    any_loads = any_loads || sum_[s] > 0;
  }
  acts_.resize(mass_.size());
  for (std::size_t s = 0; s < mass_.size(); ++s) {
    const double rounding = reach * reach * rounding_[s];
    acts_[s] = std::max(measure_[s], mass_[s] / mass * whole);
    measure_[s] = std::max(acts_[s], rounding / (tolerance * tolerance));
    // Where nothing is asked of the body, what is left of its motion may be its rounding.
    if (!any_loads) acts_[s] = measure_[s];
  }
}

void PieceNorms::raise(const std::vector<Vec3>& impulses) {
  squares(impulses, &sum_);
  for (std::size_t s = 0; s < mass_.size(); ++s) {
    measure_[s] = std::max(measure_[s], sum_[s]);
    acts_[s] = std::max(acts_[s], sum_[s]);
  }
}

PieceNorms::Ratio PieceNorms::worstRatio(const std::vector<Vec3>& r) {
  squares(r, &sum_);
  return {worstOver(measure_), worstOver(acts_)};
}

/// The square root of the largest sum over that of its piece, or the first that is not finite.
double PieceNorms::worstOver(const std::vector<double>& measure) const {
  double worst = 0;
  for (std::size_t s = 0; s < mass_.size(); ++s) {
    if (sum_[s] <= worst * measure[s]) continue;
    worst = sum_[s] / measure[s];
    if (!std::isfinite(worst)) break;
  }
  return std::sqrt(worst);
}

bool PieceNorms::floatIsTooCoarse(const std::vector<Vec3>& dv, double tolerance) const {
  double square = 0, total = 0;
  for (std::size_t c = 0; c < piece_.size(); ++c)
    if (squared_scale_[c] > 0) square += dv[c].squaredNorm() / squared_scale_[c];
  for (double measure : measure_) total += measure;
  return std::numeric_limits<float>::epsilon() * std::sqrt(square) > ROUNDING_SHARE * tolerance * std::sqrt(total);
}

}  // namespace incision
