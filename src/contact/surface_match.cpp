#include "incision/contact/surface_match.h"

#include <algorithm>

#include "incision/base/lists.h"
#include "incision/surface/mesh_points.h"

namespace incision {
namespace {

/// A triangle's vertices from the lowest on, in its sense of rotation.
std::array<int, 3> fromLowest(std::array<int, 3> triangle) {
  std::rotate(triangle.begin(), std::min_element(triangle.begin(), triangle.end()), triangle.end());
  return triangle;
}

/// Places at rest that are farther from each other than this, in elements, are two.
constexpr double ONE_PLACE = 1e-6;

/// The numbers 0 … count − 1 that are none of those in `taken`.
std::vector<int> others(const std::vector<int>& taken, int count) {
  std::vector<char> is_taken(count, false);
  for (int i : taken)
    if (i >= 0) is_taken[i] = true;
  std::vector<int> rest;
  for (int i = 0; i < count; ++i)
    if (!is_taken[i]) rest.push_back(i);
  return rest;
}

class Matcher {
 public:
  Matcher(const SurfaceOutline& before, const ContactSurface& now) : before_(before), now_(now) {}

  SurfaceMatch run() {
    matchVertices();
    matchTriangles();
    findWhole();
    matchSamples();
    matchEdges();
    matchPieces();
    match_.new_triangles = others(match_.triangles, static_cast<int>(now_.surface->triangles.size()));
    match_.new_samples = others(match_.samples, static_cast<int>(now_.samples.size()));
    match_.new_edges = others(match_.edges, static_cast<int>(now_.edges.size()));
    return std::move(match_);
  }

 private:
  void matchVertices() {
    const std::vector<SurfaceVertex>& vertices = now_.surface->vertices;
    int copies = 0;
    for (const SurfaceVertex& vertex : vertices) copies = std::max(copies, vertex.copies[0] + 1);
    for (const SurfaceVertex& vertex : before_.vertices) copies = std::max(copies, vertex.copies[0] + 1);
    Lists<int> at_copy;  // the first of each vertex
    at_copy.sort(copies, [&](const auto& add) {
      for (std::size_t v = 0; v < vertices.size(); ++v) add(vertices[v].copies[0], static_cast<int>(v));
    });
    for (std::size_t was = 0; was < before_.vertices.size(); ++was) {
      const Span<const int> near = std::as_const(at_copy)[before_.vertices[was].copies[0]];
      const auto* found = std::find_if(near.begin(), near.end(), [&](int v) { return isSame(was, v); });
      match_.vertices.push_back(found == near.end() ? -1 : *found);
    }
  }

  bool isSame(std::size_t was, int is) const {
    const SurfaceVertex &a = before_.vertices[was], &b = now_.surface->vertices[is];
    return a.copies == b.copies && (a.weights - b.weights).cwiseAbs().maxCoeff() <= SAME_POINT &&
           (before_.rest[was] - now_.rest[is]).norm() <= ONE_PLACE * now_.size[is];
  }

  void matchTriangles() {
    const auto& triangles = now_.surface->triangles;
    Lists<int> by_lowest;
    by_lowest.sort(static_cast<int>(now_.surface->vertices.size()), [&](const auto& add) {
      for (std::size_t t = 0; t < triangles.size(); ++t) add(fromLowest(triangles[t])[0], static_cast<int>(t));
    });
    for (const auto& [a, b, c] : before_.triangles) {
      const std::array<int, 3> wanted = fromLowest({match_.vertices[a], match_.vertices[b], match_.vertices[c]});
      int found = -1;
      if (wanted[0] >= 0)
        for (int t : std::as_const(by_lowest)[wanted[0]])
          if (fromLowest(triangles[t]) == wanted) found = t;
      match_.triangles.push_back(found);
    }
  }

  /// A vertex is whole where it has the triangles round it that it had.
  void findWhole() {
    std::vector<int> lost(before_.vertices.size(), 0), was(before_.vertices.size(), 0);
    std::vector<int> is(now_.surface->vertices.size(), 0);
    for (std::size_t t = 0; t < before_.triangles.size(); ++t)
      for (int v : before_.triangles[t]) {
        ++was[v];
        lost[v] += match_.triangles[t] < 0;
      }
    for (const auto& triangle : now_.surface->triangles)
      for (int v : triangle) ++is[v];
    for (std::size_t v = 0; v < before_.vertices.size(); ++v)
      whole_.push_back(match_.vertices[v] >= 0 && lost[v] == 0 && was[v] == is[match_.vertices[v]]);
  }

  void matchSamples() {
    match_.samples.assign(before_.samples.size(), -1);
    for (std::size_t v = 0; v < before_.vertices.size(); ++v) {
      if (!whole_[v]) continue;
      const int first = before_.sample_start[v], count = before_.sample_start[v + 1] - first;
      const int now = match_.vertices[v], first_now = now_.sample_start[now];
      if (now_.sample_start[now + 1] - first_now != count) continue;
      for (int k = 0; k < count; ++k)
        if (hasSameTriangles(before_.samples[first + k], now_.samples[first_now + k]))
          match_.samples[first + k] = first_now + k;
    }
  }

  bool hasSameTriangles(const ContactSurface::Sample& was, const ContactSurface::Sample& is) const {
    if (was.last - was.first != is.last - is.first) return false;
    for (int k = 0; k < was.last - was.first; ++k)
      if (match_.triangles[before_.around[was.first + k]] != now_.around[is.first + k]) return false;
    return true;
  }

  void matchEdges() {
    for (const ContactSurface::Edge& edge : before_.edges) {
      int found = -1;
      if (whole_[edge.from] && whole_[edge.to]) {
        const int a = match_.vertices[edge.from], b = match_.vertices[edge.to], from = std::min(a, b);
        for (int e = now_.edge_start[from]; e < now_.edge_start[from + 1]; ++e)
          if (now_.edges[e].to == std::max(a, b)) found = e;
      }
      match_.edges.push_back(found);
    }
  }

  void matchPieces() {
    constexpr int NONE = -1, SEVERAL = -2;
    const auto note = [](int piece, int* at) { *at = *at == NONE || *at == piece ? piece : SEVERAL; };
    std::vector<int> from(now_.pieces, NONE);
    match_.pieces.assign(before_.pieces, NONE);
    for (std::size_t v = 0; v < before_.vertices.size(); ++v) {
      if (match_.vertices[v] < 0) continue;
      const int was = before_.vertex_piece[v], is = now_.vertex_piece[match_.vertices[v]];
      note(is, &match_.pieces[was]);
      note(was, &from[is]);
    }
    for (int& piece : match_.pieces)
      if (piece == SEVERAL || (piece >= 0 && from[piece] == SEVERAL)) piece = -1;
  }

  const SurfaceOutline& before_;
  const ContactSurface& now_;
  std::vector<char> whole_;  // of each vertex there was
  SurfaceMatch match_;
};

}  // namespace

SurfaceOutline::SurfaceOutline(const ContactSurface& surface)
    : vertices(surface.surface->vertices),
      rest(surface.rest),
      triangles(surface.surface->triangles),
      pieces(surface.pieces),
      vertex_piece(surface.vertex_piece),
      sample_start(surface.sample_start),
      around(surface.around),
      edge_start(surface.edge_start),
      samples(surface.samples),
      edges(surface.edges) {}

SurfaceMatch match(const SurfaceOutline& before, const ContactSurface& now) { return Matcher(before, now).run(); }

}  // namespace incision
