#include "incision/cut/crack.h"

#include <Eigen/Geometry>
#include <cmath>

#include "incision/cut/cut_mesh.h"
#include "incision/cut/point.h"

namespace incision {
CrackField planeField(const PlaneCut& plane, const CutMesh& mesh, const std::vector<Vec3>& x) {
  const Vec3 n = plane.normal.stableNormalized();
  CrackField field;
  field.phi.resize(x.size());
  for (int c = 0; c < mesh.numCopies(); ++c) {
    const double phi = n.dot(x[c] - plane.point);
    field.phi[c] = std::abs(phi) < SNAP * mesh.shortestEdge(mesh.copyNode(c)) ? 0 : phi;
  }
  if (!plane.bounded()) return field;
  const Vec3 t = plane.tangentInPlane().normalized(), b = n.cross(t);
  field.contains = [plane, t, b, &mesh, &x](int part, const std::vector<Barycentric>& polygon) {
    const Vec3 r = at(mesh.parts()[part], polygonCentroid(polygon), x) - plane.point;
    return (plane.length == 0 || std::abs(t.dot(r)) <= plane.length / 2) &&
           (plane.width == 0 || std::abs(b.dot(r)) <= plane.width / 2);
  };
  return field;
}

}  // namespace incision
