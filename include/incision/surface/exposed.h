#pragma once

#include <vector>

#include "incision/cut/cut_mesh.h"

namespace incision {

/// The convex polygons with which the parts bound their pieces, counter-clockwise seen from outside.
struct ExposedPolygons {
  struct Polygon {
    int part;
    bool cut_face;    ///< made by a crack, not the body's skin
    int first, last;  ///< its corners are corners[first] … corners[last − 1]
  };
  std::vector<Polygon> polygons;
  std::vector<Barycentric> corners;  ///< in the element of the polygon's part
};

/// A part is exposed where it lies on the mesh's boundary, where a crack cut it out of its element, and where a crack
/// severs it from a part across a face: there each of the two shows the region they share.
ExposedPolygons exposedPolygons(const CutMesh& mesh);

}  // namespace incision
