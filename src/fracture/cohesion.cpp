#include "incision/fracture/cohesion.h"

#include <algorithm>
#include <cmath>

#include "incision/fracture/rankine.h"

namespace incision {
namespace {

/// κ = STEEPNESS E / h for an element of size h. A crack that has just gone through an element is not yet open, and the
/// traction starts from zero: with this slope it is back at σ_t when the faces are apart by a twentieth of what the
/// element itself has stretched. Steeper slopes only spoil the solver's conditioning.
constexpr double STEEPNESS = 20;

/// κ is at least this many times σ_t / δ_c, so that the traction rises before it falls.
constexpr double LEAST_STEEPNESS = 4;

}  // namespace

Cohesion::Cohesion(const FractureSettings& settings, const Materials& materials) : materials_(materials) {
  const Regions& regions = materials.regions();
  const auto energies = regions.values(settings.fracture_energy, &RegionSettings::fracture_energy);
  const std::vector<Strength> strengths = strengthsOf(settings, regions);
  for (int r = 0; r < regions.count(); ++r) {
    const double energy = energies[r].value_or(0), strength = strengths[r].tensile;
    laws_.push_back({strength, energy, 2 * energy / strength});
  }
}

void Cohesion::add(const Insertion& done, const CutMesh& mesh, const std::vector<Vec3>& x) {
  for (int p : done.parts) {
    const Part& part = mesh.parts()[p];
    const Polytope& polytope = mesh.polytope(p);
    const Facet* facet = facetOf(polytope, done.crack);
    if (!facet) continue;
    const int region = materials_.regions().of(part.element);
    const Law& law = laws_[region];
    if (law.last_opening == 0) continue;
    Bond bond;
    bond.region = region;
    bond.section = sectionOf(mesh, p, *facet);
    bond.area = vectorArea(polytope, *facet, [&](const Barycentric& b) { return at(part, b, x); }).norm();
    bond.steepest =
        std::max(STEEPNESS * materials_.stiffness(part.element), LEAST_STEEPNESS * law.strength / law.last_opening);
    memory_.bonds.push_back(bond);
  }
}

void Cohesion::changed(const CutMesh& mesh) {
  const auto torn = [&](Bond& bond) { return !findSides(mesh, &bond.section); };
  memory_.bonds.erase(std::remove_if(memory_.bonds.begin(), memory_.bonds.end(), torn), memory_.bonds.end());
}

/// The traction where a section has just opened to its widest. Below δ_0 = σ_t / κ it is κ δ; beyond, σ_t (δ_c − δ) /
/// (δ_c − δ_0). The triangle's area is σ_t δ_c / 2 = G whatever κ is. A section that has been open by δ keeps to the
/// line from zero to the traction there.
double Cohesion::traction(const Bond& bond, double opening) const {
  const Law& law = lawOf(bond);
  const double rise = law.strength / bond.steepest, last = law.last_opening;
  const double opened = std::max({bond.opened, opening, rise});
  return opened < last ? law.strength * (last - opened) / (last - rise) : 0;
}

bool Cohesion::begin(const StepStart& start, std::vector<Spring>* springs) {
  stretches_.resize(memory_.bonds.size());
  bool any_parted = false;
  for (std::size_t i = 0; i < stretches_.size(); ++i) {
    const Section& section = memory_.bonds[i].section;
    const Part &plus = start.mesh.parts()[section.plus], &minus = start.mesh.parts()[section.minus];
    Stretch& stretch = stretches_[i];
    stretch.bonded = Spring();
    for (int I = 0; I < 4; ++I) stretch.bonded.add(plus.copies[I], section.point[I]);
    for (int I = 0; I < 4; ++I) stretch.bonded.add(minus.copies[I], -section.point[I]);
    const Polytope& polytope = start.mesh.polytope(section.plus);
    const Facet* facet = facetOf(polytope, section.crack);
    stretch.parted = facet && plus.copies != minus.copies;  // what is restored may name a part without one
    any_parted = any_parted || stretch.parted;
    stretch.start = weightedSum(stretch.bonded, start.motion.x);
    const auto placed = [&](const Barycentric& b) { return at(plus, b, start.motion.x); };
    stretch.normal = facet ? Vec3(-vectorArea(polytope, *facet, placed).stableNormalized()) : Vec3::Zero();
    const Bond& bond = memory_.bonds[i];
    stretch.limit = traction(bond, 0);
    stretch.slope = stretch.limit / std::max(bond.opened, lawOf(bond).strength / bond.steepest);
    springs->push_back(stretch.bonded);
  }
  return any_parted;
}

/// A traction that falls as a section opens has no convex potential; one that rises to a limit and stays there has. So
/// the limit is a bound: the traction where the section has come to. It goes wrong by no more than the tissue beside
/// the section would be stretched by what the traction has still to fall.
void Cohesion::takeBounds(Span<const Vec3> moved, Span<const double> share) {
  for (int i = 0; i < moved.size(); ++i) {
    Stretch& stretch = stretches_[static_cast<std::size_t>(i)];
    const Vec3 y = stretch.start + moved[i], &n = stretch.normal;
    const double limit = traction(memory_.bonds[static_cast<std::size_t>(i)], (y - std::min(0.0, n.dot(y)) * n).norm());
    stretch.limit += share[i] * (limit - stretch.limit);
  }
}

/// Opening follows the distance of y from where the faces cross, crossing its component along the normal.
void Cohesion::update(Span<const Vec3> moved, Span<Spring> springs) {
  for (int i = 0; i < moved.size(); ++i) {
    const Bond& bond = memory_.bonds[static_cast<std::size_t>(i)];
    const Stretch& stretch = stretches_[static_cast<std::size_t>(i)];
    if (!stretch.parted) continue;
    const Vec3 y = stretch.start + moved[i], &n = stretch.normal;
    const double crossing = std::min(0.0, n.dot(y));
    const Vec3 open = y - crossing * n;
    const double opening = open.norm();
    const bool is_limited = stretch.slope * opening > stretch.limit;
    const double slope = is_limited ? stretch.limit / opening : stretch.slope;
    Mat3 stiffness = slope * Mat3::Identity();
    if (is_limited) stiffness -= slope / (opening * opening) * open * open.transpose();
    if (crossing < 0) stiffness += (bond.steepest - slope) * n * n.transpose();
    springs[i].set(bond.area * stiffness, -bond.area * (slope * open + bond.steepest * crossing * n), moved[i]);
  }
}

void Cohesion::accept(const StepSpan& /*span*/, Span<const Vec3> /*moved*/, const Motion& end, const Wrench& /*felt*/) {
  const auto isOpen = [&](const Bond& bond) { return bond.opened >= lawOf(bond).last_opening; };
  for (std::size_t i = 0; i < stretches_.size(); ++i) {
    Bond& bond = memory_.bonds[i];
    const Vec3 y = weightedSum(stretches_[i].bonded, end.x), n = stretches_[i].normal;
    bond.opened = std::max(bond.opened, (y - std::min(0.0, n.dot(y)) * n).norm());
    if (isOpen(bond)) memory_.spent += bond.area * lawOf(bond).energy;
  }
  memory_.bonds.erase(std::remove_if(memory_.bonds.begin(), memory_.bonds.end(), isOpen), memory_.bonds.end());
}

/// The area under the curve up to `opened`, less the triangle that closing gives back.
double Cohesion::energyOf(const Bond& bond) const {
  const Law& law = lawOf(bond);
  const double rise = law.strength / bond.steepest, last = law.last_opening;
  if (bond.opened <= rise) return 0;
  return bond.area * law.strength * last * (bond.opened - rise) / (2 * (last - rise));
}

double Cohesion::dissipated() const {
  double sum = memory_.spent;
  for (const Bond& bond : memory_.bonds) sum += energyOf(bond);
  return sum;
}

}  // namespace incision
