#pragma once

#include <Eigen/Geometry>
#include <vector>

#include "incision/base/memory_limits.h"
#include "incision/cut/cut_mesh.h"
#include "incision/cut/point.h"

namespace incision {

/// Where a crack has split a part: the flat polygon between what became of it.
struct Section {
  int crack, element;
  Barycentric point;  ///< of the polygon
  Vec3 across;        ///< its normal at rest, unit, towards the positive side
  int plus, minus;    ///< the parts on either side that have the point
};

template <class Archive>
void serialize(Archive& archive, Section& section) {
  auto& [crack, element, point, across, plus, minus] = section;
  archive(crack, element, point, across, plus, minus);
}

void check(const Section& section, const MemoryLimits& limits);

/// The facet that a crack has cut, or null when the part has none.
const Facet* facetOf(const Polytope& polytope, int crack);

/// Corners of a facet.
std::vector<Barycentric> cornersOf(const Polytope& polytope, const Facet& facet);

/// Vector area of a flat polygon of `count` corners: the points corner(0), corner(1), …
template <typename Corner>
Vec3 vectorAreaOf(std::size_t count, const Corner& corner) {
  Vec3 area = Vec3::Zero();
  const Vec3 base = corner(0);
  for (std::size_t i = 2; i < count; ++i) area += (corner(i - 1) - base).cross(corner(i) - base) / 2;
  return area;
}

/// Vector area of a facet, outwards, with its corners mapped to points by `place`.
template <typename Place>
Vec3 vectorArea(const Polytope& polytope, const Facet& facet, const Place& place) {
  return vectorAreaOf(facet.corners.size(),
                      [&](std::size_t i) -> Vec3 { return place(polytope.corners[facet.corners[i]]); });
}

/// Vector area of a polygon, by the sense in which its corners run, with these mapped to points by `place`.
template <typename Place>
Vec3 vectorArea(const std::vector<Barycentric>& polygon, const Place& place) {
  return vectorAreaOf(polygon.size(), [&](std::size_t i) -> Vec3 { return place(polygon[i]); });
}

/// The section that a crack's facet of a part is, when it has just been split with this part on the positive side. The
/// point is the centroid.
Section sectionOf(const CutMesh& mesh, int part, const Facet& facet);

/// Finds the parts on either side again, as later cracks may have split them. Returns false where rounding has left
/// none.
bool findSides(const CutMesh& mesh, Section* section);

}  // namespace incision
