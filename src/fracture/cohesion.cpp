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

Cohesion::Cohesion(const FractureSettings& settings, const Materials& materials)
    : strength_(settings.tensile_strength), energy_(*settings.fracture_energy), materials_(materials) {}

void Cohesion::add(const Insertion& done, const CutMesh& mesh, const std::vector<Vec3>& x) {
  for (int p : done.parts) {
    const Part& part = mesh.parts()[p];
    const Polytope& polytope = mesh.polytope(p);
    const Facet* facet = facetOf(polytope, done.crack);
    if (!facet) continue;
    Bond bond;
    bond.section = sectionOf(mesh, p, *facet);
    bond.area = vectorArea(polytope, *facet, [&](const Barycentric& b) { return at(part, b, x); }).norm();
    bond.steepest =
        std::max(STEEPNESS * materials_.stiffness(part.element), LEAST_STEEPNESS * strength_ / lastOpening());
    memory_.bonds.push_back(bond);
  }
}

void Cohesion::changed(const CutMesh& mesh) {
  const auto torn = [&](Bond& bond) { return !findSides(mesh, &bond.section); };
  memory_.bonds.erase(std::remove_if(memory_.bonds.begin(), memory_.bonds.end(), torn), memory_.bonds.end());
}

/// Below δ_0 = σ_t / κ the traction is κ δ; beyond, σ_t (δ_c − δ) / (δ_c − δ_0). The triangle's area is σ_t δ_c / 2 = G
/// whatever κ is. A section that has been open by δ keeps to the line from zero to the traction there.
double Cohesion::slope(const Bond& bond, double opening) const {
  const double rise = strength_ / bond.steepest, last = lastOpening();
  const double opened = std::max(bond.opened, opening);
  if (opened <= rise) return bond.steepest;
  return opened < last ? strength_ * (last - opened) / ((last - rise) * opened) : 0;
}

bool Cohesion::begin(const StepStart& start) {
  stretches_.resize(memory_.bonds.size());
  for (std::size_t i = 0; i < stretches_.size(); ++i) {
    const Section& section = memory_.bonds[i].section;
    const Part &plus = start.mesh.parts()[section.plus], &minus = start.mesh.parts()[section.minus];
    Stretch& stretch = stretches_[i];
    stretch.bonded = Spring();
    for (int I = 0; I < 4; ++I) stretch.bonded.add(plus.copies[I], section.point[I]);
    for (int I = 0; I < 4; ++I) stretch.bonded.add(minus.copies[I], -section.point[I]);
    stretch.parted = plus.copies != minus.copies;
    stretch.start = weightedSum(stretch.bonded, start.motion.x);
    const Polytope& polytope = start.mesh.polytope(section.plus);
    const auto placed = [&](const Barycentric& b) { return at(plus, b, start.motion.x); };
    stretch.normal = -vectorArea(polytope, *facetOf(polytope, section.crack), placed).stableNormalized();
    stretch.slope = slope(memory_.bonds[i], 0);
  }
  return !stretches_.empty();
}

bool Cohesion::update(const StepSpan& span, const std::vector<Vec3>& v_end, std::vector<Spring>* springs) {
  bool differ = false;
  for (std::size_t i = 0; i < stretches_.size(); ++i) {
    const Bond& bond = memory_.bonds[i];
    Stretch& stretch = stretches_[i];
    const Vec3 y = stretch.start + span.time_step * weightedSum(stretch.bonded, v_end), n = stretch.normal;
    const bool pressed = n.dot(y) < 0;
    const double k = slope(bond, (pressed ? Vec3(y - n.dot(y) * n) : y).norm());
    differ = differ || std::abs(k - stretch.slope) > SLOPE_TOLERANCE * std::max(k, stretch.slope);
    stretch.slope = k;
    if (!stretch.parted) continue;
    Spring spring = stretch.bonded;
    spring.stiffness = bond.area * k * Mat3::Identity();
    if (pressed) spring.stiffness += bond.area * (bond.steepest - k) * n * n.transpose();
    spring.force = -spring.stiffness * stretch.start;
    springs->push_back(spring);
  }
  return differ;
}

void Cohesion::accept(const StepSpan& /*span*/, const Motion& end, const Wrench& /*felt*/) {
  for (std::size_t i = 0; i < stretches_.size(); ++i) {
    Bond& bond = memory_.bonds[i];
    const Vec3 y = weightedSum(stretches_[i].bonded, end.x), n = stretches_[i].normal;
    bond.opened = std::max(bond.opened, (y - std::min(0.0, n.dot(y)) * n).norm());
    if (bond.opened >= lastOpening()) memory_.spent += bond.area * energy_;
  }
  const auto open = [&](const Bond& bond) { return bond.opened >= lastOpening(); };
  memory_.bonds.erase(std::remove_if(memory_.bonds.begin(), memory_.bonds.end(), open), memory_.bonds.end());
}

/// The area under the curve up to `opened`, less the triangle that closing gives back.
double Cohesion::energyOf(const Bond& bond) const {
  const double rise = strength_ / bond.steepest, last = lastOpening();
  if (bond.opened <= rise) return 0;
  return bond.area * strength_ * last * (bond.opened - rise) / (2 * (last - rise));
}

double Cohesion::dissipated() const {
  double sum = memory_.spent;
  for (const Bond& bond : memory_.bonds) sum += energyOf(bond);
  return sum;
}

}  // namespace incision
