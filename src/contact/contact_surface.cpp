#include "incision/contact/contact_surface.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <numeric>
#include <utility>

namespace incision {
namespace {

/// Triangles of a vertex whose normals turn by less than 45° from their mean make one side of it.
constexpr double MIN_COSINE = 0.7;

Vec3 areaVector(const std::vector<Vec3>& x, const std::array<int, 3>& triangle) {
  return 0.5 * (x[triangle[1]] - x[triangle[0]]).cross(x[triangle[2]] - x[triangle[0]]);
}

/// Points that are closer at rest than this, in elements, are at one place.
constexpr double SAME_PLACE = 1e-6;

/// The weight of the copies that both vertices hold.
double sharedWeight(const SurfaceVertex& a, const SurfaceVertex& b) {
  double shared = 0;
  for (int i = 0; i < 4; ++i)
    for (int k = 0; k < 4; ++k)
      if (a.copies[i] == b.copies[k]) shared += std::min(a.weights[i], b.weights[k]);
  return shared;
}

/// Vertices at one place lie on the two sides of a cut, and so in the order of their first coordinate near each other.
std::vector<double> ownWeights(const ContactSurface& surface) {
  std::vector<int> order;
  std::vector<char> is_cut(surface.rest.size(), false);
  for (std::size_t t = 0; t < surface.surface->triangles.size(); ++t) {
    if (!surface.surface->cut_face[t]) continue;
    for (int v : surface.surface->triangles[t])
      if (!std::exchange(is_cut[v], true)) order.push_back(v);
  }
  const auto at = [&](int v) { return surface.rest[v].sum(); };
  std::sort(order.begin(), order.end(), [&](int a, int b) { return at(a) < at(b); });
  std::vector<double> own(surface.rest.size(), 1);
  for (std::size_t i = 0; i < order.size(); ++i) {
    const int a = order[i];
    const double near = SAME_PLACE * surface.size[a];
    for (std::size_t k = i + 1; k < order.size() && at(order[k]) - at(a) < 2 * near; ++k) {
      const int b = order[k];
      if ((surface.rest[a] - surface.rest[b]).norm() > near) continue;
      const double left = 1 - sharedWeight(surface.surface->vertices[a], surface.surface->vertices[b]);
      own[a] = std::min(own[a], left);
      own[b] = std::min(own[b], left);
    }
  }
  return own;
}

class Builder {
 public:
  explicit Builder(ContactSurface* made) : made_(*made) {}

  void run(const CutMesh& mesh) {
    const auto& triangles = made_.surface->triangles;
    const std::size_t vertices = made_.surface->vertices.size();
    made_.size.assign(vertices, 0);
    made_.area.assign(vertices, 0);
    std::vector<int> count(vertices + 1, 0);
    for (std::size_t t = 0; t < triangles.size(); ++t) {
      areas_.push_back(areaVector(made_.rest, triangles[t]));
      const double size = std::cbrt(6 * elementVolume(mesh.mesh(), mesh.parts()[made_.surface->part[t]].element));
      for (int v : triangles[t]) {
        made_.size[v] += size;
        made_.area[v] += areas_[t].norm() / 3;
        ++count[v + 1];
      }
    }
    for (std::size_t v = 0; v < vertices; ++v) made_.size[v] /= std::max(1, count[v + 1]);
    std::partial_sum(count.begin(), count.end(), count.begin());
    std::vector<int> round(count.back()), next(count.begin(), count.end() - 1);
    for (std::size_t t = 0; t < triangles.size(); ++t)
      for (int v : triangles[t]) round[next[v]++] = static_cast<int>(t);
    for (std::size_t v = 0; v < vertices; ++v) {
      made_.sample_start.push_back(static_cast<int>(made_.samples.size()));
      addSamples(static_cast<int>(v), {round.begin() + count[v], round.begin() + count[v + 1]});
    }
    made_.sample_start.push_back(static_cast<int>(made_.samples.size()));
  }

 private:
  /// Takes the triangles one after the other into the first side they are flat with.
  void addSamples(int vertex, std::vector<int> triangles) {
    while (!triangles.empty()) {
      ContactSurface::Sample sample{vertex, static_cast<int>(made_.around.size()), 0, 0};
      Vec3 sum = Vec3::Zero();
      const bool cut = made_.surface->cut_face[triangles.front()];
      std::vector<int> others;
      for (int t : triangles) {
        const Vec3& a = areas_[t];
        const bool flat = sum.isZero(0) || a.dot(sum) > MIN_COSINE * a.norm() * sum.norm();
        if (made_.surface->cut_face[t] != cut || !flat) {
          others.push_back(t);
          continue;
        }
        sum += a;
        sample.area += a.norm() / 3;
        made_.around.push_back(t);
      }
      sample.last = static_cast<int>(made_.around.size());
      if (sample.area > 0) made_.samples.push_back(sample);
      triangles = std::move(others);
    }
  }

  ContactSurface& made_;
  std::vector<Vec3> areas_;
};

}  // namespace

ContactSurface makeContactSurface(const Surface& surface, const CutMesh& mesh, const std::vector<int>& piece) {
  ContactSurface made;
  made.surface = &surface;
  std::vector<Vec3> X;
  for (int c = 0; c < mesh.numCopies(); ++c) X.push_back(mesh.mesh().nodes[mesh.copyNode(c)]);
  made.rest = surfacePositions(surface, X);
  for (const SurfaceVertex& vertex : surface.vertices) made.vertex_piece.push_back(piece[vertex.copies[0]]);
  for (const auto& triangle : surface.triangles) made.piece.push_back(made.vertex_piece[triangle[0]]);
  Builder(&made).run(mesh);
  made.own = ownWeights(made);
  for (double size : made.size) made.mean_size += size / static_cast<double>(made.size.size());
  return made;
}

void addVertex(const SurfaceVertex& vertex, double sign, Coupling* coupling) {
  for (int k = 0; k < 4; ++k)
    if (vertex.weights[k] != 0) coupling->add(vertex.copies[k], sign * vertex.weights[k]);
}

}  // namespace incision
