#include "incision/cut/crack.h"

#include <Eigen/Geometry>
#include <cmath>

#include "incision/cut/cut_mesh.h"
#include "incision/cut/point.h"

namespace incision {
namespace {

/// Beyond this [m] a plane has no digits left to tell two nodes of a body apart.
constexpr double MAX_COORDINATE = 1e9;

/// Shortest component of the tangent across the unit normal, of a unit tangent, that still gives a direction.
constexpr double MIN_ACROSS = 1e-6;

bool usable(const Vec3& v) { return v.allFinite() && v.cwiseAbs().maxCoeff() <= MAX_COORDINATE; }

bool isSize(double s) { return std::isfinite(s) && s >= 0 && s <= MAX_COORDINATE; }

/// The tangent less its component along the unit normal `n`.
Vec3 across(const Vec3& tangent, const Vec3& n) {
  const Vec3 t = tangent.stableNormalized();
  return t - t.dot(n) * n;
}

}  // namespace

std::string whyInvalid(const PlaneCut& plane) {
  if (!usable(plane.point)) return "point: not finite or beyond 1e9 m";
  if (!usable(plane.normal)) return "normal: not finite or beyond 1e9";
  if (!usable(plane.tangent)) return "tangent: not finite or beyond 1e9";
  if (!isSize(plane.length)) return "length: not a finite number from 0 to 1e9 m";
  if (!isSize(plane.width)) return "width: not a finite number from 0 to 1e9 m";
  if (plane.normal.stableNorm() == 0) return "normal: zero";
  if (plane.bounded() && across(plane.tangent, plane.normal.stableNormalized()).norm() < MIN_ACROSS)
    return "tangent: zero or parallel to the normal, so length and width have no direction";
  return "";
}

CrackField planeField(const PlaneCut& plane, const CutMesh& mesh, const std::vector<Vec3>& x) {
  const Vec3 n = plane.normal.stableNormalized();
  CrackField field;
  field.phi.resize(x.size());
  for (int c = 0; c < mesh.numCopies(); ++c) {
    const double phi = n.dot(x[c] - plane.point);
    field.phi[c] = std::abs(phi) < SNAP * mesh.shortestEdge(mesh.copyNode(c)) ? 0 : phi;
  }
  if (!plane.bounded()) return field;
  const Vec3 t = across(plane.tangent, n).normalized(), b = n.cross(t);
  field.contains = [plane, t, b, &mesh, &x](int part, const std::vector<Barycentric>& polygon) {
    const Vec3 r = at(mesh.parts()[part], polygonCentroid(polygon), x) - plane.point;
    return (plane.length == 0 || std::abs(t.dot(r)) <= plane.length / 2) &&
           (plane.width == 0 || std::abs(b.dot(r)) <= plane.width / 2);
  };
  return field;
}

}  // namespace incision
