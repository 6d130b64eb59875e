#include "incision/fracture/front.h"

#include <Eigen/Geometry>
#include <Eigen/LU>
#include <algorithm>
#include <cmath>

#include "incision/cut/section.h"

namespace incision {
namespace {

/// Steepest angle [rad] between the crack's normal and the face. At π/2 the crack would run in the face and never enter
/// the element.
constexpr double MAX_SLOPE = 1.3;

/// The face's frame: `across` is the unit normal, `up` the unit gradient of φ in the face, `slope` its size.
struct FaceFrame {
  Vec3 across, up;
  double slope;
};

FaceFrame frameOf(const Front& front) {
  const Vec3 a = front.face[1] - front.face[0], b = front.face[2] - front.face[0];
  const Vec3 area = a.cross(b);
  const double da = front.phi[1] - front.phi[0], db = front.phi[2] - front.phi[0];
  // ∇φ in the plane of a and b: ∇φ·a = da, ∇φ·b = db.
  const Vec3 gradient = (da * b.cross(area) + db * area.cross(a)) / area.squaredNorm();
  return {area.normalized(), gradient.normalized(), gradient.norm()};
}

/// Angle of a normal of either sense, turned about the fringe line from `up` towards `across`, in (−π/2, π/2] of
/// `from`.
double angleNear(const FaceFrame& frame, const Vec3& normal, double from) {
  const double x = normal.dot(frame.up), y = normal.dot(frame.across);
  if (x == 0 && y == 0) return from;  // the line lies along the normal: no turn about it helps
  const double turn = std::remainder(std::atan2(y, x) - from, M_PI);
  return from + turn;
}

/// ∇φ [1] in the body as it is deformed, of a field given at a part's copies.
Vec3 gradient(const Part& part, const Eigen::Vector4d& phi, const std::vector<Vec3>& x) {
  Mat3 edges;
  for (int k = 0; k < 3; ++k) edges.row(k) = x[part.copies[k + 1]] - x[part.copies[0]];
  return edges.fullPivLu().solve(Vec3(phi.tail<3>().array() - phi[0]));
}

}  // namespace

Front frontOf(const Fringe& fringe, const GrowingCrack& crack, const CutMesh& mesh, const std::vector<Vec3>& x) {
  const Part &ahead = mesh.parts()[fringe.ahead], &behind = mesh.parts()[fringe.behind];
  Front front;
  for (int i = 0; i < 3; ++i) {
    const int copy = ahead.copies[FACE_NODES[fringe.face][i]];
    front.face[i] = x[copy];
    front.phi[i] = crack.phi.at(copy);
  }
  front.behind = gradient(behind, *phiAt(crack, behind), x);
  return front;
}

// On the face φ is given: its gradient there is s e, e unit, and the crack ends along the line ℓ = m × e, m being the
// face's unit normal. A plane through this line has its normal in the plane of e and m, at an angle θ from e. In the
// element ahead
//   ∇φ = s (e + m tan θ),
// which keeps φ on the face. The normal n wanted is met as closely as possible by the θ of its projection onto that
// plane, n − (n·ℓ) ℓ: then ∇φ·t = 0 for the direction t in the plane across n that lies ahead of the line.
double phiBeyond(const Front& front, const Vec3& normal, const Vec3& point) {
  const FaceFrame frame = frameOf(front);
  const double from = std::atan2(front.behind.dot(frame.across), front.behind.dot(frame.up));
  const double wanted = angleNear(frame, normal, from);
  const double turned = std::clamp(wanted, from - MAX_TURN, from + MAX_TURN);
  const double angle = std::clamp(turned, -MAX_SLOPE, MAX_SLOPE);
  const Vec3 to = point - front.face[0];
  return front.phi[0] + frame.slope * (frame.up.dot(to) + std::tan(angle) * frame.across.dot(to));
}

Vec3 middleOf(const Front& front) {
  Vec3 sum = Vec3::Zero();
  int ends = 0;
  for (int i = 0; i < 3; ++i) {
    const int j = (i + 1) % 3;
    if ((front.phi[i] < 0) == (front.phi[j] < 0)) continue;
    sum += front.face[i] + front.phi[i] / (front.phi[i] - front.phi[j]) * (front.face[j] - front.face[i]);
    ++ends;
  }
  return sum / ends;
}

Vec3 normalTowards(const Front& front, const Vec3& point) {
  const FaceFrame frame = frameOf(front);
  return frame.across.cross(frame.up).cross(point - middleOf(front));
}

std::vector<CrackFace> crackFaces(const CutMesh& mesh) {
  std::vector<CrackFace> faces;
  for (int p = 0; p < static_cast<int>(mesh.parts().size()); ++p) {
    if (mesh.parts()[p].detail < 0) continue;
    const Polytope& polytope = mesh.polytope(p);
    for (const Facet& facet : polytope.facets) {
      if (facet.face >= 0) continue;
      const std::vector<Barycentric> corners = cornersOf(polytope, facet);
      for (const Barycentric& corner : corners) faces.push_back({facet.crack, p, corner});
      faces.push_back({facet.crack, p, polygonCentroid(corners)});
    }
  }
  return faces;
}

}  // namespace incision
