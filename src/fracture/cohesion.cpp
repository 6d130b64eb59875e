#include "incision/fracture/cohesion.h"

#include <algorithm>
#include <cmath>

namespace incision {
namespace {

/// κ = STEEPNESS E / h for an element of size h. A crack that has just gone through an element is not yet open, and the
/// traction starts from zero: with this slope it is back at σ_t when the faces are apart by a twentieth of what the
/// element itself has stretched. Steeper slopes only spoil the solver's conditioning.
constexpr double STEEPNESS = 20;

/// κ is at least this many times σ_t / δ_c, so that the traction rises before it falls.
constexpr double LEAST_STEEPNESS = 4;

/// Change of a slope, as a share of it, that takes another solve.
constexpr double SLOPE_TOLERANCE = 0.02;

}  // namespace

Cohesion::Cohesion(const FractureSettings& settings, double young_modulus)
    : strength_(settings.tensile_strength), energy_(*settings.fracture_energy), young_modulus_(young_modulus) {}

void Cohesion::add(const Insertion& done, const CutMesh& mesh, const std::vector<Vec3>& x) {
  const double last = 2 * energy_ / strength_;
  for (int p : done.parts) {
    const Part& part = mesh.parts()[p];
    const Polytope& polytope = mesh.polytope(p);
    const Facet* facet = facetOf(polytope, done.crack);
    if (!facet) continue;
    Held held;
    held.section = sectionOf(mesh, p, *facet);
    held.area = vectorArea(polytope, *facet, [&](const Barycentric& b) { return at(part, b, x); }).norm();
    held.steepest = std::max(STEEPNESS * young_modulus_ / std::cbrt(elementVolume(mesh.mesh(), part.element)),
                             LEAST_STEEPNESS * strength_ / last);
    held_.push_back(held);
  }
}

void Cohesion::topologyChanged(const CutMesh& mesh) {
  const auto torn = [&](Held& held) { return !findSides(mesh, &held.section); };
  held_.erase(std::remove_if(held_.begin(), held_.end(), torn), held_.end());
}

// Below δ_0 = σ_t / κ the traction is κ δ; beyond, σ_t (δ_c − δ) / (δ_c − δ_0). The triangle's area is σ_t δ_c / 2 = G
// whatever κ is. A section that has been open by δ keeps to the line from zero to the traction there.
double Cohesion::slope(const Held& held, double opening) const {
  const double rise = strength_ / held.steepest, last = 2 * energy_ / strength_;
  const double opened = std::max(held.opened, opening);
  if (opened <= rise) return held.steepest;
  return opened < last ? strength_ * (last - opened) / ((last - rise) * opened) : 0;
}

Vec3 Cohesion::openingAt(const Held& held, const std::vector<Vec3>& values) const {
  Vec3 y = Vec3::Zero();
  for (int i = 0; i < 8; ++i) y += held.weights[i] * values[held.copies[i]];
  return y;
}

void Cohesion::begin(const CutMesh& mesh, const std::vector<Vec3>& x) {
  for (Held& held : held_) {
    const Part &plus = mesh.parts()[held.section.plus], &minus = mesh.parts()[held.section.minus];
    for (int I = 0; I < 4; ++I) {
      held.copies[I] = plus.copies[I];
      held.copies[4 + I] = minus.copies[I];
      held.weights[I] = held.section.point[I];
      held.weights[4 + I] = -held.section.point[I];
    }
    held.start = openingAt(held, x);
    held.parted = plus.copies != minus.copies;
    const Polytope& polytope = mesh.polytope(held.section.plus);
    const auto placed = [&](const Barycentric& b) { return at(plus, b, x); };
    held.normal = -vectorArea(polytope, *facetOf(polytope, held.section.crack), placed).stableNormalized();
    held.used = slope(held, 0);
  }
}

bool Cohesion::update(double time_step, const std::vector<Vec3>& v_end, std::vector<Coupling>* couplings) {
  bool changed = false;
  for (Held& held : held_) {
    const Vec3 y = held.start + time_step * openingAt(held, v_end), n = held.normal;
    const bool pressed = n.dot(y) < 0;
    const double k = slope(held, (pressed ? Vec3(y - n.dot(y) * n) : y).norm());
    changed = changed || std::abs(k - held.used) > SLOPE_TOLERANCE * std::max(k, held.used);
    held.used = k;
    if (!held.parted) continue;
    Coupling coupling;
    coupling.stiffness = held.area * k * Mat3::Identity();
    if (pressed) coupling.stiffness += held.area * (held.steepest - k) * n * n.transpose();
    coupling.force = -coupling.stiffness * held.start;
    for (int i = 0; i < 8; ++i) coupling.add(held.copies[i], held.weights[i]);
    couplings->push_back(coupling);
  }
  return changed;
}

void Cohesion::accept(const std::vector<Vec3>& x) {
  const double last = 2 * energy_ / strength_;
  for (Held& held : held_) {
    const Vec3 y = openingAt(held, x);
    const double along = std::min(0.0, held.normal.dot(y));
    held.opened = std::max(held.opened, (y - along * held.normal).norm());
    if (held.opened >= last) spent_ += held.area * energy_;
  }
  const auto open = [&](const Held& held) { return held.opened >= last; };
  held_.erase(std::remove_if(held_.begin(), held_.end(), open), held_.end());
}

/// The area under the curve up to `opened`, less the triangle that closing gives back.
double Cohesion::energyOf(const Held& held) const {
  const double rise = strength_ / held.steepest, last = 2 * energy_ / strength_;
  if (held.opened <= rise) return 0;
  return held.area * strength_ * last * (held.opened - rise) / (2 * (last - rise));
}

double Cohesion::dissipated() const {
  double sum = spent_;
  for (const Held& held : held_) sum += energyOf(held);
  return sum;
}

}  // namespace incision
