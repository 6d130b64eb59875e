#include "incision/contact/contact_surface.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <numeric>
#include <tuple>
#include <utility>

namespace incision {
namespace {

/// Triangles of a vertex whose normals turn by less than 45° from their mean make one side of it.
constexpr double MIN_COSINE = 0.7;

/// Edges whose triangles' normals turn by less than 10° are flat: two that cross overlap by 2 % of an element at most
/// before a vertex meets a triangle.
constexpr double FLAT_COSINE = 0.985;

/// Points that are closer at rest than this, in elements, are at one place.
constexpr double SAME_PLACE = 1e-6;

/// The weight of the copies that both vertices have.
double sharedWeight(const SurfaceVertex& a, const SurfaceVertex& b) {
  double shared = 0;
  for (int i = 0; i < 4; ++i)
    for (int k = 0; k < 4; ++k)
      if (a.copies[i] == b.copies[k]) shared += std::min(a.weights[i], b.weights[k]);
  return shared;
}

/// ContactSurface::unshared of every vertex. Vertices at one place lie on the two sides of a cut, and are near each
/// other when all vertices of cuts are sorted by the sum of their coordinates.
std::vector<double> unsharedWeights(const ContactSurface& surface) {
  std::vector<int> sorted;
  std::vector<char> is_cut(surface.rest.size(), false);
  for (std::size_t t = 0; t < surface.surface->triangles.size(); ++t) {
    if (!surface.surface->cut_face[t]) continue;
    for (int v : surface.surface->triangles[t])
      if (!std::exchange(is_cut[v], true)) sorted.push_back(v);
  }
  const auto at = [&](int v) { return surface.rest[v].sum(); };
  std::sort(sorted.begin(), sorted.end(), [&](int a, int b) { return at(a) < at(b); });
  std::vector<double> unshared(surface.rest.size(), 1);
  for (std::size_t i = 0; i < sorted.size(); ++i) {
    const int a = sorted[i];
    const double near = SAME_PLACE * surface.size[a];
    for (std::size_t k = i + 1; k < sorted.size() && at(sorted[k]) - at(a) < 2 * near; ++k) {
      const int b = sorted[k];
      if ((surface.rest[a] - surface.rest[b]).norm() > near) continue;
      const double rest = 1 - sharedWeight(surface.surface->vertices[a], surface.surface->vertices[b]);
      unshared[a] = std::min(unshared[a], rest);
      unshared[b] = std::min(unshared[b], rest);
    }
  }
  return unshared;
}

/// A triangle beside an edge, as the one or the other runs along it.
struct Side {
  int from, to, opposite, triangle;
};

/// The sides of all edges by their first vertices, those of one edge together.
Lists<Side> sidesOfEdges(const Surface& surface) {
  Lists<Side> sides;
  sides.sort(static_cast<int>(surface.vertices.size()), [&](const auto& add) {
    for (int t = 0; t < static_cast<int>(surface.triangles.size()); ++t)
      for (int k = 0; k < 3; ++k) {
        const auto& triangle = surface.triangles[t];
        const int a = triangle[k], b = triangle[(k + 1) % 3];
        add(std::min(a, b), Side{std::min(a, b), std::max(a, b), triangle[(k + 2) % 3], t});
      }
  });
  for (int v = 0; v < sides.count(); ++v) {
    const Span<Side> of_vertex = sides[v];
    std::sort(of_vertex.begin(), of_vertex.end(),
              [](const Side& a, const Side& b) { return std::tie(a.to, a.triangle) < std::tie(b.to, b.triangle); });
  }
  return sides;
}

bool isSharp(const ContactSurface& surface, const Side& one, const Side& other) {
  const Vec3 &n = surface.rest_normal[one.triangle], &m = surface.rest_normal[other.triangle];
  return n.dot(surface.rest[other.opposite] - surface.rest[one.from]) < 0 && n.dot(m) < FLAT_COSINE;
}

void addEdges(ContactSurface* surface) {
  const Lists<Side> of_vertices = sidesOfEdges(*surface->surface);
  const std::vector<Side>& sides = of_vertices.values();
  const auto same = [](const Side& a, const Side& b) { return a.from == b.from && a.to == b.to; };
  surface->edge_start.assign(surface->rest.size() + 1, 0);
  for (std::size_t i = 0, end = 0; i < sides.size(); i = end) {
    while (end < sides.size() && same(sides[i], sides[end])) ++end;
    if (end != i + 2 || !isSharp(*surface, sides[i], sides[i + 1])) continue;
    if (!hasAreaAtRest(*surface, sides[i].triangle) || !hasAreaAtRest(*surface, sides[i + 1].triangle)) continue;
    surface->edges.push_back(
        {sides[i].from, sides[i].to, {sides[i].opposite, sides[i + 1].opposite}, sides[i].triangle});
    ++surface->edge_start[sides[i].from + 1];
  }
  std::partial_sum(surface->edge_start.begin(), surface->edge_start.end(), surface->edge_start.begin());
}

class Builder {
 public:
  explicit Builder(ContactSurface* made) : made_(*made) {}

  void run(const CutMesh& mesh, const Materials& materials) {
    const auto& triangles = made_.surface->triangles;
    const std::size_t vertices = made_.surface->vertices.size();
    made_.size.assign(vertices, 0);
    made_.area.assign(vertices, 0);
    made_.young_modulus.assign(vertices, 0);
    for (std::size_t t = 0; t < triangles.size(); ++t) {
      const int element = mesh.parts()[made_.surface->part[t]].element;
      const double size = materials.size(element);
      for (int v : triangles[t]) {
        made_.size[v] += size;
        made_.area[v] += made_.rest_area[t] / 3;
        made_.young_modulus[v] = std::max(made_.young_modulus[v], materials.youngModulus(element));
      }
    }
    Lists<int> triangles_at;  // each vertex
    triangles_at.sort(static_cast<int>(vertices), [&](const auto& add) {
      for (std::size_t t = 0; t < triangles.size(); ++t)
        for (int v : triangles[t]) add(v, static_cast<int>(t));
    });
    for (int v = 0; v < triangles_at.count(); ++v) {
      const Span<const int> around = std::as_const(triangles_at)[v];
      made_.size[v] /= std::max(1, around.size());
      made_.sample_start.push_back(static_cast<int>(made_.samples.size()));
      left_.assign(around.begin(), around.end());
      while (!left_.empty()) addSample(v);
    }
    made_.sample_start.push_back(static_cast<int>(made_.samples.size()));
  }

 private:
  /// Takes of the triangles that are left, one after the other, those into a sample that are flat with it so far.
  void addSample(int vertex) {
    ContactSurface::Sample sample{vertex, static_cast<int>(made_.around.size()), 0, 0};
    Vec3 sum = Vec3::Zero();
    const bool cut = made_.surface->cut_face[left_.front()];
    std::size_t others = 0;
    for (int t : left_) {
      const bool flat = sum.isZero(0) || made_.rest_normal[t].dot(sum) > MIN_COSINE * sum.norm();
      if (made_.surface->cut_face[t] != cut || !flat) {
        left_[others++] = t;
        continue;
      }
      sum += made_.rest_area[t] * made_.rest_normal[t];
      sample.area += made_.rest_area[t] / 3;
      made_.around.push_back(t);
    }
    left_.resize(others);
    sample.last = static_cast<int>(made_.around.size());
    if (sample.area > 0) made_.samples.push_back(sample);
  }

  ContactSurface& made_;
  std::vector<int> left_;  // triangles round a vertex that are in no sample yet
};

}  // namespace

ContactSurface makeContactSurface(const Surface& surface, const CutMesh& mesh, const Materials& materials,
                                  const std::vector<int>& piece) {
  ContactSurface made;
  made.surface = &surface;
  std::vector<Vec3> X;
  for (int c = 0; c < mesh.numCopies(); ++c) X.push_back(mesh.mesh().nodes[mesh.copyNode(c)]);
  made.rest = surfacePositions(surface, X);
  for (const SurfaceVertex& vertex : surface.vertices) made.vertex_piece.push_back(piece[vertex.copies[0]]);
  for (const auto& [a, b, c] : surface.triangles) {
    made.piece.push_back(made.vertex_piece[a]);
    const Vec3 twice = (made.rest[b] - made.rest[a]).cross(made.rest[c] - made.rest[a]);
    made.rest_area.push_back(twice.norm() / 2);
    made.rest_normal.push_back(twice.stableNormalized());
  }
  Builder(&made).run(mesh, materials);
  addEdges(&made);
  for (int p : piece) made.pieces = std::max(made.pieces, p + 1);
  made.unshared = unsharedWeights(made);
  made.cut_triangles.sort(static_cast<int>(mesh.parts().size()), [&](const auto& add) {
    for (std::size_t t = 0; t < surface.triangles.size(); ++t)
      if (surface.cut_face[t]) add(surface.part[t], static_cast<int>(t));
  });
  for (double size : made.size) made.mean_size += size / static_cast<double>(made.size.size());
  return made;
}

bool hasAreaAtRest(const ContactSurface& surface, int triangle) {
  const double size = surface.size[surface.surface->triangles[triangle][0]];
  return 2 * surface.rest_area[triangle] > MIN_OVERLAP * size * size;
}

void addVertex(const SurfaceVertex& vertex, double sign, Spring* spring) {
  for (int k = 0; k < 4; ++k)
    if (vertex.weights[k] != 0) spring->add(vertex.copies[k], sign * vertex.weights[k]);
}

}  // namespace incision
