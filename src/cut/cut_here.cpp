#include "incision/cut/cut_here.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <limits>

#include "incision/base/nearest.h"
#include "incision/cut/section.h"

namespace incision {
namespace {

/// How far beyond a face's rim still counts as over it, as a share of the distance asked for: rounding.
constexpr double RIM = 1e-6;

/// Calls f(facet, crack) for the faces along which a part is cut, until one returns true. Returns whether one did. Of a
/// face of the mesh, the crack may have severed some of what lies across only.
template <typename Function>
bool anyCutFacet(const CutMesh& mesh, int part, const Function& f) {
  if (mesh.parts()[part].detail < 0) return false;
  const CutPart& cut = mesh.detail(part);
  return std::any_of(cut.polytope.facets.begin(), cut.polytope.facets.end(), [&](const Facet& facet) {
    if (facet.face < 0) return f(facet, facet.crack);
    return std::any_of(cut.face_sides.begin(), cut.face_sides.end(),
                       [&](const FaceSide& side) { return side.face == facet.face && f(facet, side.crack); });
  });
}

/// A cut face of a part, at rest.
class CutFace {
 public:
  CutFace(const CutMesh& mesh, int part, const Facet& facet)
      : mesh_(mesh), polytope_(mesh.polytope(part)), facet_(facet), part_(part), element_(mesh.parts()[part].element) {
    base_ = corner(0);
    normal_ = vectorAreaOf(facet.corners.size(), [&](std::size_t i) { return corner(i); }).stableNormalized();
  }

  /// [m]
  double fromPlane(const Vec3& point) const { return std::abs(normal_.dot(point - base_)); }

  bool turnedBy(const Vec3& normal, double cosine) const {
    return normal.isZero(0) || std::abs(normal_.dot(normal)) > cosine * normal.norm();
  }

  /// How far a point is from the face along its plane [m]; 0 where it lies over the face.
  double beyondRim(const Vec3& point) const {
    return beyondRim(point, facet_.corners.size(), [&](std::size_t i) { return corner(i); });
  }

  /// How far a point is along the plane of a face of the mesh from what a crack has severed of it [m].
  double beyondSevered(const Vec3& point, int crack) const {
    double beyond = std::numeric_limits<double>::infinity();
    for (const FacePair& pair : mesh_.facePairs(element_, facet_.face)) {
      if (pair.part != part_ || pair.severed_by != crack) continue;
      const std::vector<Barycentric> polygon = inElement(pair.polygon, facet_.face);
      beyond = std::min(
          beyond, beyondRim(point, polygon.size(), [&](std::size_t i) { return atRest(mesh_, element_, polygon[i]); }));
    }
    return beyond;
  }

  /// Largest |φ| over the corners, φ being given at the nodes of the face's element.
  double farthest(const Eigen::Vector4d& phi) const {
    double far = 0;
    for (int c : facet_.corners) far = std::max(far, std::abs(phi.dot(polytope_.corners[c])));
    return far;
  }

 private:
  Vec3 corner(std::size_t i) const { return atRest(mesh_, element_, polytope_.corners[facet_.corners[i]]); }

  /// How far a point is along the plane from a polygon in it, given by its corners counter-clockwise round the normal.
  template <typename Corner>
  double beyondRim(const Vec3& point, std::size_t count, const Corner& place) const {
    double inside = 1, nearest = std::numeric_limits<double>::infinity();
    const Vec3 image = point - normal_.dot(point - base_) * normal_;
    for (std::size_t i = 0; i < count; ++i) {
      const Vec3 from = place(i), to = place((i + 1) % count);
      inside = std::min(inside, normal_.dot((to - from).cross(image - from)));
      nearest = std::min(nearest, (image - nearestOnSegment(from, to, image)).norm());
    }
    return inside >= 0 ? 0 : nearest;
  }

  const CutMesh& mesh_;
  const Polytope& polytope_;
  const Facet& facet_;
  int part_, element_;
  Vec3 base_, normal_;
};

/// Calls f(element) for the elements that share a node with one, until a call returns true. Returns whether one did.
template <typename Function>
bool anyNeighbour(const CutMesh& mesh, int element, const Function& f) {
  const std::array<int, 4>& nodes = mesh.mesh().elements[element];
  for (auto node = nodes.begin(); node != nodes.end(); ++node)
    for (int other : mesh.topology().star[*node]) {
      const std::array<int, 4>& its = mesh.mesh().elements[other];
      const bool met_before = std::find_first_of(nodes.begin(), node, its.begin(), its.end()) != node;
      if (!met_before && other != element && f(other)) return true;
    }
  return false;
}

/// Whether a point is within a distance [m] of the box round an element at rest.
bool isNearBox(const CutMesh& mesh, int element, const Vec3& point, double distance) {
  Eigen::AlignedBox3d box;
  for (int node : mesh.mesh().elements[element]) box.extend(mesh.mesh().nodes[node]);
  return box.squaredExteriorDistance(point) < distance * distance;
}

}  // namespace

bool isCutHere(const CutMesh& mesh, int part, const CutSought& sought) {
  const auto near = [&](const CutFace& face) {
    return face.fromPlane(sought.point) < sought.distance && face.turnedBy(sought.normal, sought.cosine);
  };
  const auto isOver = [&](const CutFace& face, double beyond) {
    return beyond <= std::max(face.fromPlane(sought.point), RIM * sought.distance);
  };
  const auto isOwn = [&](const Facet& facet, int crack) {
    const CutFace face(mesh, part, facet);
    return near(face) && (facet.face < 0 || isOver(face, face.beyondSevered(sought.point, crack)));
  };
  if (anyCutFacet(mesh, part, isOwn)) return true;

  const auto besideCutOf = [&](int other) {
    return anyCutFacet(mesh, other, [&](const Facet& facet, int crack) {
      if (crack == sought.growing) return false;
      const CutFace face(mesh, other, facet);
      if (!near(face) || !isOver(face, face.beyondRim(sought.point))) return false;
      return facet.face < 0 || isOver(face, face.beyondSevered(sought.point, crack));
    });
  };
  return anyNeighbour(mesh, mesh.parts()[part].element, [&](int element) {
    // As far from the face along it as across, a point is √2 times that away.
    if (mesh.isWhole(element) || !isNearBox(mesh, element, sought.point, 1.5 * sought.distance)) return false;
    for (int p = element; p >= 0; p = mesh.parts()[p].next)
      if (besideCutOf(p)) return true;
    return false;
  });
}

bool isCutHere(const CutMesh& mesh, int part, const std::vector<Barycentric>& section, const Eigen::Vector4d& phi,
               double distance) {
  const int element = mesh.parts()[part].element;
  return anyCutFacet(mesh, part, [&](const Facet& facet, int) {
    const CutFace face(mesh, part, facet);
    return face.farthest(phi) < distance && std::all_of(section.begin(), section.end(), [&](const Barycentric& b) {
             return face.fromPlane(atRest(mesh, element, b)) < distance;
           });
  });
}

}  // namespace incision
