#include "incision/cut/section.h"

#include <algorithm>
#include <limits>

namespace incision {
namespace {

/// How far inside the facet a point of its plane is, as a distance from the nearest edge at rest [m]. `out` is the
/// facet's vector area.
double insideness(const Polytope& polytope, const Facet& facet, const Vec3& out, const CutMesh& mesh, int element,
                  const Vec3& point) {
  double least = std::numeric_limits<double>::infinity();
  const auto corner = [&](std::size_t i) {
    return atRest(mesh, element, polytope.corners[facet.corners[i % facet.corners.size()]]);
  };
  for (std::size_t i = 0; i < facet.corners.size(); ++i) {
    const Vec3 from = corner(i), edge = corner(i + 1) - from;
    least = std::min(least, out.stableNormalized().dot(edge.stableNormalized().cross(point - from)));
  }
  return least;
}

/// The part on one side of a section that has its point, and how far inside its facet.
struct Side {
  int part = -1;
  double inside = 0;  // [m]
};

}  // namespace

const Facet* facetOf(const Polytope& polytope, int crack) {
  for (const Facet& facet : polytope.facets)
    if (facet.crack == crack) return &facet;
  return nullptr;
}

std::vector<Barycentric> cornersOf(const Polytope& polytope, const Facet& facet) {
  std::vector<Barycentric> corners;
  for (int c : facet.corners) corners.push_back(polytope.corners[c]);
  return corners;
}

Section sectionOf(const CutMesh& mesh, int part, const Facet& facet) {
  const int element = mesh.parts()[part].element;
  const Polytope& polytope = mesh.polytope(part);
  const Vec3 out = vectorArea(polytope, facet, [&](const Barycentric& b) { return atRest(mesh, element, b); });
  const Barycentric centroid = polygonCentroid(cornersOf(polytope, facet));
  return {facet.crack, element, centroid, -out.stableNormalized(), part, mesh.parts()[part].next};
}

bool findSides(const CutMesh& mesh, Section* section) {
  const Vec3 point = atRest(mesh, section->element, section->point);
  Side plus, minus;
  for (int p = section->element; p >= 0; p = mesh.parts()[p].next) {
    const Polytope& polytope = mesh.polytope(p);
    const Facet* facet = facetOf(polytope, section->crack);
    if (!facet) continue;
    const auto resting = [&](const Barycentric& b) { return atRest(mesh, section->element, b); };
    const Vec3 out = vectorArea(polytope, *facet, resting);
    const double inside = insideness(polytope, *facet, out, mesh, section->element, point);
    Side& side = out.dot(section->across) < 0 ? plus : minus;
    if (side.part < 0 || inside > side.inside) side = {p, inside};
  }
  section->plus = plus.part;
  section->minus = minus.part;
  return plus.part >= 0 && minus.part >= 0;
}

}  // namespace incision
