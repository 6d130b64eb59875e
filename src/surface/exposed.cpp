#include "incision/surface/exposed.h"

#include <algorithm>
#include <array>
#include <utility>

namespace incision {
namespace {

class Collector {
 public:
  explicit Collector(const CutMesh& mesh) : mesh_(mesh) {}

  ExposedPolygons run() {
    for (std::size_t p = 0; p < mesh_.parts().size(); ++p) addFacets(static_cast<int>(p));
    for (int e = 0; e < static_cast<int>(mesh_.mesh().elements.size()); ++e)
      for (int f = 0; f < 4 && !mesh_.isWhole(e); ++f)
        if (mesh_.topology().neighbours[e][f] > e && mayBeSevered(e, f)) addSevered(e, f);
    return std::move(exposed_);
  }

 private:
  /// What the part shows by itself: skin and cut facets.
  void addFacets(int part) {
    const auto& neighbours = mesh_.topology().neighbours[mesh_.parts()[part].element];
    const bool at_skin = *std::min_element(neighbours.begin(), neighbours.end()) < 0;
    if (mesh_.parts()[part].detail < 0 && !at_skin) return;
    const Polytope& polytope = mesh_.polytope(part);
    for (const Facet& facet : polytope.facets) {
      const bool cut_face = facet.face < 0;
      if (!cut_face && neighbours[facet.face] >= 0) continue;
      for (int c : facet.corners) exposed_.corners.push_back(polytope.corners[c]);
      close(part, cut_face);
    }
  }

  bool mayBeSevered(int element, int face) const {
    for (int p = element; p >= 0; p = mesh_.parts()[p].next) {
      if (mesh_.parts()[p].detail < 0) continue;
      for (const FaceSide& side : mesh_.detail(p).face_sides)
        if (side.face == face) return true;
    }
    return false;
  }

  /// What parts on both sides of a face show where a crack severs them.
  void addSevered(int element, int face) {
    const auto& nodes = mesh_.mesh().elements[element];
    const auto& nodes_across = mesh_.mesh().elements[mesh_.topology().neighbours[element][face]];
    std::array<int, 3> across;  // the face's nodes, as the neighbour numbers them
    for (int i = 0; i < 3; ++i) {
      const auto at = std::find(nodes_across.begin(), nodes_across.end(), nodes[FACE_NODES[face][i]]);
      across[i] = static_cast<int>(at - nodes_across.begin());
    }
    for (const FacePair& pair : mesh_.facePairs(element, face)) {
      if (!pair.severed_by) continue;
      for (const FacePoint& point : pair.polygon) addFacePoint(FACE_NODES[face], point);
      close(pair.part, true);
      for (auto point = pair.polygon.rbegin(); point != pair.polygon.rend(); ++point) addFacePoint(across, *point);
      close(pair.other, true);
    }
  }

  void addFacePoint(const std::array<int, 3>& nodes, const FacePoint& point) {
    Barycentric b = Barycentric::Zero();
    for (int i = 0; i < 3; ++i) b[nodes[i]] = point[i];
    exposed_.corners.push_back(b);
  }

  /// Makes a polygon of the corners added since the last one.
  void close(int part, bool cut_face) {
    const int first = exposed_.polygons.empty() ? 0 : exposed_.polygons.back().last;
    exposed_.polygons.push_back({part, cut_face, first, static_cast<int>(exposed_.corners.size())});
  }

  const CutMesh& mesh_;
  ExposedPolygons exposed_;
};

}  // namespace

ExposedPolygons exposedPolygons(const CutMesh& mesh) { return Collector(mesh).run(); }

}  // namespace incision
