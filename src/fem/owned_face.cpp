#include "incision/fem/owned_face.h"

namespace incision {

FacePolygon ownedFace(const CutMesh& mesh, int part, int face) {
  FacePolygon polygon;
  const Polytope& polytope = mesh.polytope(part);
  const Facet* facet = polytope.onFace(face);
  if (!facet) return polygon;
  for (int c : facet->corners) {
    const Barycentric& b = polytope.corners[c];
    polygon.emplace_back(b[FACE_NODES[face][0]], b[FACE_NODES[face][1]], b[FACE_NODES[face][2]]);
  }
  return polygon;
}

}  // namespace incision
