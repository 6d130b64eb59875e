#include <algorithm>

#include "incision/tool/blade/stroke.h"

namespace incision {
namespace {

/// How far from an element, in its own coordinates, a sweep still counts as passing it. A crack that is one plane in
/// each element runs beside the swept surface by what that bends within one, and so through elements that the surface
/// itself just misses.
constexpr double ENTRY_MARGIN = 0.5;

/// How far from a cut element, in its own coordinates, a sweep still frees it: on a path that curves within two
/// elements the blade is beside the far end of the crack in one when it is well into the next.
constexpr double FREEING_MARGIN = 1;

/// How far the edge must move through the tissue, in edges of the mesh, to be followed: tissue that trembles round a
/// blade at rest is not cut, and a slow blade cuts in as many pieces as matter.
constexpr double MIN_MOTION = 0.01;

/// How far the edge must move across itself, as a share of its length, for a sweep to have a direction; an edge that
/// moves along itself moves by rounding.
constexpr double MIN_SWEEP = 1e-9;

/// Whether all of a sweep, its corners given in an element's coordinates, lies outside the element by more than
/// `margin`. A long edge passes by many elements with its ends beyond different faces.
bool outside(const std::array<Barycentric, 4>& corners, double margin) {
  for (int I = 0; I < 4; ++I)
    if (std::all_of(corners.begin(), corners.end(), [&](const Barycentric& b) { return b[I] < -margin; })) return true;
  return !reaches({corners[0], corners[1], corners[2]}, margin) &&
         !reaches({corners[0], corners[2], corners[3]}, margin);
}

/// Whether a sweep within `reach`, its corners given in an element's coordinates, meets what cracks have left of the
/// element to a part. The rest of the element follows copies that are nowhere near the material: `was` and `is` tell
/// where that is before and after.
bool meetsMaterial(const CutMesh& mesh, int part, const std::array<Barycentric, 4>& corners, const PartFrame& was,
                   const PartFrame& is, const Eigen::AlignedBox3d& reach) {
  if (mesh.parts()[part].detail < 0) return true;
  const Polytope& polytope = mesh.polytope(part);
  Eigen::AlignedBox3d box;
  for (const Barycentric& b : polytope.corners) box.extend(was.toBody(b)).extend(is.toBody(b));
  return reach.intersects(box) && (reaches({corners[0], corners[1], corners[2]}, polytope) ||
                                   reaches({corners[0], corners[2], corners[3]}, polytope));
}

}  // namespace

/// Finds the parts that the sweep passes. It starts where the last sweep left the element's material, so the surface
/// has no gaps however the tissue moves under the blade. Returns false where the edge has hardly moved in any.
bool Stroke::record(const Stand& last, const Edge& to, const std::vector<Vec3>& x, const CutMesh& mesh) {
  passed_.clear();
  beside_.clear();
  const Vec3 direction = (to[1] - to[0]).normalized();
  const double least = MIN_SWEEP * (to[1] - to[0]).norm();
  Eigen::AlignedBox3d reach;
  for (const Edge& edge : {last.edge, to})
    for (const Vec3& end : edge) reach.extend(end);
  bool near = false, moved = false;
  for (const int p : near_->find(reach, FREEING_MARGIN, x, last.x)) {
    const Part& part = mesh.parts()[p];
    const Eigen::AlignedBox3d box = boxOf(part, x).merged(boxOf(part, last.x));
    const auto meets = [&](double margin) {
      const Vec3 room = margin * box.sizes();
      return reach.intersects(Eigen::AlignedBox3d(box.min() - room, box.max() + room));
    };
    if (!meets(part.detail >= 0 ? FREEING_MARGIN : ENTRY_MARGIN)) continue;
    const PartFrame was(part, last.x), is(part, x);
    if (!was.invertible() || !is.invertible()) continue;
    Passed passed;
    passed.part = p;
    passed.corners = {was.toElement(last.edge[0]), was.toElement(last.edge[1]), is.toElement(to[1]),
                      is.toElement(to[0])};
    if (outside(passed.corners, FREEING_MARGIN)) continue;
    if (!meets(ENTRY_MARGIN) || outside(passed.corners, ENTRY_MARGIN)) {
      if (part.detail >= 0) beside_.push_back(passed);
      continue;
    }
    const Edge carried = {is.toBody(passed.corners[0]), is.toBody(passed.corners[1])};
    near = true;
    moved = moved ||
            std::max((to[0] - carried[0]).norm(), (to[1] - carried[1]).norm()) > MIN_MOTION * shortestEdge(part, mesh);
    const Vec3 centre = is.toBody(Barycentric::Constant(0.25));
    passed.normal = direction.cross(nearest(to, centre) - nearest(carried, centre));
    if (!(passed.normal.norm() > least)) continue;
    passed.within = !outside(passed.corners, 0) && meetsMaterial(mesh, passed.part, passed.corners, was, is, reach);
    passed_.push_back(passed);
  }
  if (near && !moved) return false;
  memory_.begun =
      memory_.begun || std::any_of(passed_.begin(), passed_.end(), [](const Passed& passed) { return passed.within; });
  return true;
}

void Stroke::keepTriangles(const CutMesh& mesh) {
  just_swept_.clear();
  const auto keep = [&](const Passed& passed) {
    const std::array<Barycentric, 4>& c = passed.corners;
    std::vector<SweptTriangle>& triangles = just_swept_[mesh.parts()[passed.part].element];
    triangles.push_back({c[0], c[1], c[2]});
    triangles.push_back({c[0], c[2], c[3]});
  };
  for (const Passed& passed : passed_) {
    keep(passed);
    if (known_parts_ > 0) swept_since_.push_back(mesh.parts()[passed.part].element);
  }
  for (const auto& [element, triangles] : just_swept_) memory_.swept[element].add(triangles);
  for (const Passed& passed : beside_) keep(passed);
}

}  // namespace incision
