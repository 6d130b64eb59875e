#include "incision/fracture/cohesion.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <limits>

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

Vec3 atRest(const CutMesh& mesh, int element, const Barycentric& point) {
  Vec3 X = Vec3::Zero();
  for (int I = 0; I < 4; ++I) X += point[I] * mesh.mesh().nodes[mesh.mesh().elements[element][I]];
  return X;
}

Vec3 at(const Part& part, const Barycentric& point, const std::vector<Vec3>& x) {
  Vec3 y = Vec3::Zero();
  for (int I = 0; I < 4; ++I) y += point[I] * x[part.copies[I]];
  return y;
}

/// Vector area of a facet, outwards.
template <typename Place>
Vec3 areaOf(const Facet& facet, const Polytope& polytope, const Place& place) {
  Vec3 area = Vec3::Zero();
  const Vec3 base = place(polytope.corners[facet.corners[0]]);
  for (std::size_t i = 2; i < facet.corners.size(); ++i)
    area +=
        (place(polytope.corners[facet.corners[i - 1]]) - base).cross(place(polytope.corners[facet.corners[i]]) - base) /
        2;
  return area;
}

/// How far inside the facet a point of its plane is, as a distance from the nearest edge at rest [m].
double insideness(const Facet& facet, const Polytope& polytope, const CutMesh& mesh, int element, const Vec3& point) {
  const auto place = [&](int i) {
    return atRest(mesh, element, polytope.corners[facet.corners[static_cast<std::size_t>(i)]]);
  };
  const Vec3 out =
      areaOf(facet, polytope, [&](const Barycentric& b) { return atRest(mesh, element, b); }).stableNormalized();
  const int corners = static_cast<int>(facet.corners.size());
  double least = std::numeric_limits<double>::infinity();
  for (int i = 0; i < corners; ++i) {
    const Vec3 edge = place((i + 1) % corners) - place(i);
    least = std::min(least, out.dot(edge.stableNormalized().cross(point - place(i))));
  }
  return least;
}

/// The part on one side of a section that has its centroid, and how far inside its facet.
struct Side {
  int part = -1;
  double inside = 0;  // [m]
};

const Facet* facetOf(const Polytope& polytope, int crack) {
  for (const Facet& facet : polytope.facets)
    if (facet.crack == crack) return &facet;
  return nullptr;
}

}  // namespace

Cohesion::Cohesion(const FractureSettings& settings, double young_modulus)
    : strength_(settings.tensile_strength), energy_(*settings.fracture_energy), young_modulus_(young_modulus) {}

void Cohesion::add(const Insertion& done, const CutMesh& mesh, const std::vector<Vec3>& x) {
  const double last = 2 * energy_ / strength_;
  for (int p : done.parts) {
    const Part& part = mesh.parts()[p];
    const Facet* facet = facetOf(mesh.polytope(p), done.crack);
    if (!facet) continue;
    const Polytope& polytope = mesh.polytope(p);
    std::vector<Barycentric> corners;
    for (int c : facet->corners) corners.push_back(polytope.corners[c]);
    const auto placed = [&](const Barycentric& b) { return at(part, b, x); };
    const auto resting = [&](const Barycentric& b) { return atRest(mesh, part.element, b); };
    Section section;
    section.crack = done.crack;
    section.centroid = polygonCentroid(corners);
    section.across = -areaOf(*facet, polytope, resting).stableNormalized();
    section.plus = p;
    section.minus = part.next;  // split off from it just now
    section.area = areaOf(*facet, polytope, placed).norm();
    section.steepest = std::max(STEEPNESS * young_modulus_ / std::cbrt(elementVolume(mesh.mesh(), part.element)),
                                LEAST_STEEPNESS * strength_ / last);
    sections_.push_back(section);
  }
}

/// A later crack may have split the part on either side: the section is held by those pieces that have its centroid.
void Cohesion::topologyChanged(const CutMesh& mesh) {
  const auto torn = [&](Section& section) {
    const int element = mesh.parts()[section.plus].element;
    const Vec3 point = atRest(mesh, element, section.centroid);
    Side plus, minus;
    for (int p = element; p >= 0; p = mesh.parts()[p].next) {
      const Facet* facet = facetOf(mesh.polytope(p), section.crack);
      if (!facet) continue;
      const Vec3 out = areaOf(*facet, mesh.polytope(p), [&](const Barycentric& b) { return atRest(mesh, element, b); });
      const double inside = insideness(*facet, mesh.polytope(p), mesh, element, point);
      Side& side = out.dot(section.across) < 0 ? plus : minus;
      if (side.part < 0 || inside > side.inside) side = {p, inside};
    }
    section.plus = plus.part;
    section.minus = minus.part;
    return plus.part < 0 || minus.part < 0;  // cut away by rounding
  };
  sections_.erase(std::remove_if(sections_.begin(), sections_.end(), torn), sections_.end());
}

// Below δ_0 = σ_t / κ the traction is κ δ; beyond, σ_t (δ_c − δ) / (δ_c − δ_0). The triangle's area is σ_t δ_c / 2 = G
// whatever κ is. A section that has been open by δ keeps to the line from zero to the traction there.
double Cohesion::slope(const Section& section, double opening) const {
  const double rise = strength_ / section.steepest, last = 2 * energy_ / strength_;
  const double opened = std::max(section.opened, opening);
  if (opened <= rise) return section.steepest;
  return opened < last ? strength_ * (last - opened) / ((last - rise) * opened) : 0;
}

Vec3 Cohesion::openingAt(const Section& section, const std::vector<Vec3>& values) const {
  Vec3 y = Vec3::Zero();
  for (int i = 0; i < 8; ++i) y += section.weights[i] * values[section.copies[i]];
  return y;
}

void Cohesion::begin(const CutMesh& mesh, const std::vector<Vec3>& x) {
  for (Section& section : sections_) {
    const Part &plus = mesh.parts()[section.plus], &minus = mesh.parts()[section.minus];
    for (int I = 0; I < 4; ++I) {
      section.copies[I] = plus.copies[I];
      section.copies[4 + I] = minus.copies[I];
      section.weights[I] = section.centroid[I];
      section.weights[4 + I] = -section.centroid[I];
    }
    section.start = openingAt(section, x);
    section.parted = plus.copies != minus.copies;
    const Polytope& polytope = mesh.polytope(section.plus);
    const auto placed = [&](const Barycentric& b) { return at(plus, b, x); };
    section.normal = -areaOf(*facetOf(polytope, section.crack), polytope, placed).stableNormalized();
    section.used = slope(section, 0);
  }
}

bool Cohesion::update(double time_step, const std::vector<Vec3>& v_end, std::vector<Coupling>* couplings) {
  bool changed = false;
  for (Section& section : sections_) {
    const Vec3 y = section.start + time_step * openingAt(section, v_end), n = section.normal;
    const bool pressed = n.dot(y) < 0;
    const double k = slope(section, (pressed ? Vec3(y - n.dot(y) * n) : y).norm());
    changed = changed || std::abs(k - section.used) > SLOPE_TOLERANCE * std::max(k, section.used);
    section.used = k;
    if (!section.parted) continue;
    Coupling coupling;
    coupling.stiffness = section.area * k * Mat3::Identity();
    if (pressed) coupling.stiffness += section.area * (section.steepest - k) * n * n.transpose();
    coupling.force = -coupling.stiffness * section.start;
    for (int i = 0; i < 8; ++i) coupling.add(section.copies[i], section.weights[i]);
    couplings->push_back(coupling);
  }
  return changed;
}

void Cohesion::accept(const std::vector<Vec3>& x) {
  const double last = 2 * energy_ / strength_;
  for (Section& section : sections_) {
    const Vec3 y = openingAt(section, x);
    const double along = std::min(0.0, section.normal.dot(y));
    section.opened = std::max(section.opened, (y - along * section.normal).norm());
    if (section.opened >= last) spent_ += section.area * energy_;
  }
  const auto open = [&](const Section& section) { return section.opened >= last; };
  sections_.erase(std::remove_if(sections_.begin(), sections_.end(), open), sections_.end());
}

/// The area under the curve up to `opened`, less the triangle that closing gives back.
double Cohesion::energyOf(const Section& section) const {
  const double rise = strength_ / section.steepest, last = 2 * energy_ / strength_;
  if (section.opened <= rise) return 0;
  return section.area * strength_ * last * (section.opened - rise) / (2 * (last - rise));
}

double Cohesion::dissipated() const {
  double sum = spent_;
  for (const Section& section : sections_) sum += energyOf(section);
  return sum;
}

}  // namespace incision
