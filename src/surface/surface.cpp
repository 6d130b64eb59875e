#include "incision/surface/surface.h"

#include <algorithm>

#include "incision/base/parallel.h"
#include "incision/surface/exposed.h"
#include "incision/surface/gaps.h"
#include "incision/surface/mesh_points.h"
#include "incision/surface/triangulate.h"

namespace incision {
namespace {

class SurfaceBuilder {
 public:
  explicit SurfaceBuilder(const CutMesh& mesh)
      : mesh_(mesh),
        exposed_(exposedPolygons(mesh)),
        points_(mesh, exposed_),
        at_copy_(mesh.numCopies(), -1),
        last_at_point_(points_.count(), -1) {}

  Surface run() {
    for (const auto& polygon : exposed_.polygons) addPolygon(polygon);
    fillGaps();
    return std::move(surface_);
  }

 private:
  void addPolygon(const ExposedPolygons::Polygon& polygon) {
    outline(polygon);
    if (loop_.size() < 3) return;
    corners_.clear();
    vertices_.clear();
    for (int point : loop_) {
      corners_.push_back(restPosition(point));
      vertices_.push_back(vertex(polygon.part, point));
    }
    for (std::size_t i = 0; i < vertices_.size(); ++i)
      edges_.push_back({vertices_[i], vertices_[(i + 1) % vertices_.size()], polygon.part});
    for (const auto& [i, j, k] : triangulate(corners_))
      addTriangle({vertices_[i], vertices_[j], vertices_[k]}, polygon.part, polygon.cut_face);
  }

  void addTriangle(const std::array<int, 3>& triangle, int part, bool cut_face) {
    // A polygon that rounding has folded on itself may come to the same vertex twice.
    if (triangle[0] == triangle[1] || triangle[1] == triangle[2] || triangle[2] == triangle[0]) return;
    surface_.triangles.push_back(triangle);
    surface_.part.push_back(part);
    surface_.cut_face.push_back(cut_face);
  }

  /// Parts that share less than MIN_OVERLAP of a face do not hang together there, nor are they severed. The gaps this
  /// leaves have no area to speak of, but an open edge would spoil the surface for most uses.
  void fillGaps() {
    for (const auto& gap : findGaps(edges_, static_cast<int>(surface_.vertices.size())))
      for (std::size_t i = 2; i < gap.size(); ++i)
        addTriangle({gap[0].from, gap[i].from, gap[i - 1].from}, gap[i].part, true);
  }

  /// The points round the polygon, those of its neighbours on its sides included.
  void outline(const ExposedPolygons::Polygon& polygon) {
    loop_.clear();
    for (int c = polygon.first; c < polygon.last; ++c) {
      const int next = c + 1 < polygon.last ? c + 1 : polygon.first;
      const int from = points_.atCorner(c), to = points_.atCorner(next);
      if (from == to) continue;
      loop_.push_back(from);
      points_.appendBetween(from, to, &loop_);
    }
  }

  Vec3 restPosition(int point) const {
    if (points_.isNode(point)) return mesh_.mesh().nodes[point];
    const MeshPoint place = points_.place(point);
    Vec3 X = Vec3::Zero();
    for (int k = 0; k < 4 && place.nodes[k] >= 0; ++k) X += place.weights[k] * mesh_.mesh().nodes[place.nodes[k]];
    return X;
  }

  /// The vertex at a point of a part's boundary: the same for all parts that use the same copies there.
  int vertex(int part, int point) {
    if (points_.isNode(point)) return vertexAtNode(mesh_.parts()[part], point);
    const SurfaceVertex wanted = surfaceVertex(mesh_.parts()[part], points_.place(point));
    int& last = last_at_point_[point];
    for (int v = last; v >= 0; v = previous_[v])
      if (surface_.vertices[v].copies == wanted.copies) return v;
    return add(wanted, &last);
  }

  int vertexAtNode(const Part& part, int node) {
    const auto& element = mesh_.mesh().elements[part.element];
    const int copy = part.copies[std::find(element.begin(), element.end(), node) - element.begin()];
    int& known = at_copy_[copy];
    return known >= 0 ? known : add({{copy, copy, copy, copy}, Barycentric::UnitX()}, &known);
  }

  /// Adds a vertex to those at its point, of which `last` is the last.
  int add(const SurfaceVertex& vertex, int* last) {
    previous_.push_back(*last);
    *last = static_cast<int>(surface_.vertices.size());
    surface_.vertices.push_back(vertex);
    return *last;
  }

  SurfaceVertex surfaceVertex(const Part& part, const MeshPoint& place) const {
    const auto& element = mesh_.mesh().elements[part.element];
    SurfaceVertex vertex{{}, place.weights};
    for (int k = 0; k < 4; ++k) {
      const auto at = std::find(element.begin(), element.end(), place.nodes[k]);
      vertex.copies[k] = at == element.end() ? vertex.copies[0] : part.copies[at - element.begin()];
    }
    return vertex;
  }

  const CutMesh& mesh_;
  const ExposedPolygons exposed_;
  MeshPoints points_;
  std::vector<int> at_copy_;        // the vertex at the node of each copy, or −1
  std::vector<int> last_at_point_;  // the last vertex made at each other point, or −1
  std::vector<int> previous_;       // of each vertex: the one made before it at the same point, or −1
  std::vector<int> loop_, vertices_;
  std::vector<Vec3> corners_;
  std::vector<SurfaceEdge> edges_;
  Surface surface_;
};

}  // namespace

Surface buildSurface(const CutMesh& mesh) { return SurfaceBuilder(mesh).run(); }

std::vector<Vec3> surfacePositions(const Surface& surface, const std::vector<Vec3>& x) {
  std::vector<Vec3> positions;
  interpolate(surface, x, 1, &positions);
  return positions;
}

void interpolate(const Surface& surface, const std::vector<Vec3>& x, int threads, std::vector<Vec3>* result) {
  result->resize(surface.vertices.size());
  parallelFor(static_cast<int>(result->size()), threads,
              [&](int i) { (*result)[i] = positionOf(surface.vertices[i], x); });
}

double enclosedVolume(const Surface& surface, const std::vector<Vec3>& positions) {
  if (surface.triangles.empty()) return 0;
  // Seen from a point of the surface: far from the origin the terms would cancel at the cost of digits.
  const Vec3& origin = positions[surface.triangles[0][0]];
  double six_volumes = 0;
  for (const auto& [a, b, c] : surface.triangles)
    six_volumes += sixVolumes(origin, positions[a], positions[b], positions[c]);
  return six_volumes / 6;
}

}  // namespace incision
