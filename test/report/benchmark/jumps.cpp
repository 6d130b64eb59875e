#include "report/benchmark/jumps.h"

#include <Eigen/Geometry>
#include <cmath>

#include "incision/cut/point.h"
#include "incision/cut/section.h"

namespace incision::report {
namespace {

constexpr double PI = 3.14159265358979323846;

/// Weights of a triangle's corners at a point; empty outside it, but for rounding.
bool weightsIn(const Vec2& a, const Vec2& b, const Vec2& c, const Vec2& point, Vec3* weights) {
  const auto area = [](const Vec2& u, const Vec2& v) { return u.x() * v.y() - u.y() * v.x(); };
  const double whole = area(b - a, c - a);
  if (whole == 0) return false;
  *weights = Vec3(area(b - point, c - point), area(c - point, a - point), area(a - point, b - point)) / whole;
  return weights->minCoeff() > -1e-9;
}

}  // namespace

Jumps::Jumps(const Rig& rig, const Insertion& done, const RoundCrack& crack) {
  const std::vector<Vec3> u = rig.displacements();
  for (int p : done.parts) {
    const Polytope& polytope = rig.mesh.polytope(p);
    const incision::Facet* cut = facetOf(polytope, done.crack);
    if (!cut) continue;  // severed on a face
    const Part &above = rig.mesh.parts()[p], &below = rig.mesh.parts()[above.next];
    Facet facet;
    std::vector<Vec3> places;
    for (const Barycentric& corner : cornersOf(polytope, *cut)) {
      places.push_back(atRest(rig.mesh, above.element, corner));
      facet.corners.push_back(crack.plan(places.back()));
      facet.jumps.push_back(incision::at(above, corner, u) - incision::at(below, corner, u));
    }
    facet.low = facet.high = facet.corners[0];
    for (const Vec2& corner : facet.corners) {
      facet.low = facet.low.cwiseMin(corner);
      facet.high = facet.high.cwiseMax(corner);
    }
    for (std::size_t i = 2; i < places.size(); ++i) {
      const Vec3 area = (places[i - 1] - places[0]).cross(places[i] - places[0]) / 2;  // out of the upper part
      moment_ -= (facet.jumps[0] + facet.jumps[i - 1] + facet.jumps[i]) / 3 * area.transpose();
    }
    facets_.push_back(facet);
  }
}

Vec3 Jumps::at(const Vec2& plan) const {
  for (const Facet& facet : facets_) {
    if ((plan.array() < facet.low.array()).any() || (plan.array() > facet.high.array()).any()) continue;
    for (std::size_t i = 2; i < facet.corners.size(); ++i) {
      Vec3 weights;
      if (weightsIn(facet.corners[0], facet.corners[i - 1], facet.corners[i], plan, &weights))
        return weights[0] * facet.jumps[0] + weights[1] * facet.jumps[i - 1] + weights[2] * facet.jumps[i];
    }
  }
  return Vec3::Zero();
}

nlohmann::json alongRays(const Jumps& jumps, const RoundCrack& crack) {
  nlohmann::json rays;
  for (int k = 0; k < RAYS; ++k) {
    const double omega = 2 * PI * k / RAYS;
    nlohmann::json ray;
    for (int i = 0; i < RAY_PLACES; ++i) {
      const double r = RAY_LENGTH * crack.radius() * (i + 0.5) / RAY_PLACES;
      const Vec3 jump = crack.axes(omega, r).transpose() * jumps.at(crack.plan(crack.place(omega, r)));
      ray.push_back({jump[0], jump[1], jump[2]});
    }
    rays.push_back(ray);
  }
  return rays;
}

}  // namespace incision::report
