#include "incision/contact/near_test.h"

#include <Eigen/Geometry>
#include <array>
#include <cmath>

#include "incision/contact/skin_in_step.h"

namespace incision {
namespace {

/// At rest closer than this, in elements, two points of a piece are neighbours, and what lies behind is material.
constexpr double NEAR_AT_REST = 3;

/// Gaps at rest, in elements, that are rounding: faces born together.
constexpr double SAME_PLANE = 1e-6;

/// At rest closer than this, in elements, two points of one flat side do not meet: it would have to fold in between.
constexpr double BESIDE_AT_REST = 1.5;

/// The cosine of the angle between triangles of one flat side is more.
constexpr double ONE_SIDE = 0.7;

/// Whether a sample and a triangle of one piece never meet: there was material in between at rest, behind the triangle,
/// or they lie beside each other.
bool staysApart(const ContactSurface& surface, const ContactSurface::Sample& sample, int triangle) {
  const Vec3 from = surface.rest[sample.vertex] - surface.rest[surface.surface->triangles[triangle][0]];
  const double size = surface.size[sample.vertex], distance = from.norm();
  if (distance >= NEAR_AT_REST * size) return false;
  const Vec3& N = surface.rest_normal[triangle];
  if (N.dot(from) < -SAME_PLANE * size) return true;
  return distance < BESIDE_AT_REST * size && N.dot(surface.rest_normal[surface.around[sample.first]]) > ONE_SIDE;
}

/// Whether a point is at most so far from a triangle's plane, and as seen along its normal beside no edge by more than
/// the reach and the triangle's rim.
bool isAbove(const std::array<Vec3, 3>& triangle, const Vec3& p, const Reach& reach) {
  const auto& [a, b, c] = triangle;
  const Vec3 n = (b - a).cross(c - a);
  const double square = n.squaredNorm(), length = std::sqrt(square);
  if (std::abs(n.dot(p - a)) > reach.further * length) return false;
  for (int k = 0; k < 3; ++k) {
    const Vec3 &from = triangle[k], edge = triangle[(k + 1) % 3] - from;
    // The weight of the third corner times n², and what an edge so far away changes of that.
    if (edge.cross(p - from).dot(n) < -RIM * square - reach.aside * edge.norm() * length) return false;
  }
  return true;
}

}  // namespace

bool mayMeet(const ContactSurface& surface, const std::vector<Vec3>& x, int sample, int triangle, const Reach& reach,
             bool of_one_piece) {
  const auto& [a, b, c] = surface.surface->triangles[triangle];
  const int vertex = surface.samples[sample].vertex;
  if (vertex == a || vertex == b || vertex == c) return false;
  return isAbove({x[a], x[b], x[c]}, x[vertex], reach) && hasAreaAtRest(surface, triangle) &&
         !(of_one_piece && staysApart(surface, surface.samples[sample], triangle));
}

}  // namespace incision
