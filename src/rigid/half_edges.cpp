#include "half_edges.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <tuple>

#include "incision/base/disjoint_sets.h"
#include "incision/base/input_error.h"

namespace incision {
namespace {

/// The edge of a triangle from a corner to the next.
struct HalfEdge {
  int low, high;  // its vertices
  int triangle, corner;
  bool rises;  // from the low to the high one
};

bool sameEdge(const HalfEdge& a, const HalfEdge& b) { return a.low == b.low && a.high == b.high; }

/// In groups of one edge each.
std::vector<HalfEdge> halfEdgesOf(const TriangleMesh& mesh) {
  std::vector<HalfEdge> edges;
  edges.reserve(3 * mesh.triangles.size());
  for (int t = 0; t < static_cast<int>(mesh.triangles.size()); ++t)
    for (int k = 0; k < 3; ++k) {
      const int a = mesh.triangles[t][k], b = mesh.triangles[t][(k + 1) % 3];
      edges.push_back({std::min(a, b), std::max(a, b), t, k, a < b});
    }
  std::sort(edges.begin(), edges.end(), [](const HalfEdge& a, const HalfEdge& b) {
    return std::tie(a.low, a.high, a.triangle, a.corner) < std::tie(b.low, b.high, b.triangle, b.corner);
  });
  return edges;
}

/// Calls f(begin, end) for all half edges of each edge.
template <typename F>
void forEachEdge(const std::vector<HalfEdge>& edges, const F& f) {
  for (auto begin = edges.begin(); begin != edges.end();) {
    const auto end = std::find_if(begin, edges.end(), [&](const HalfEdge& edge) { return !sameEdge(edge, *begin); });
    f(begin, end);
    begin = end;
  }
}

void turnOver(std::array<int, 3>* triangle) { std::swap((*triangle)[1], (*triangle)[2]); }

/// A triangle across an edge, and whether it has the edge the same way round, so that one of the two is the wrong way.
struct Across {
  int triangle = NO_NEIGHBOUR;
  bool disagrees = false;
};

std::vector<std::array<Across, 3>> simplyAcross(const TriangleMesh& mesh) {
  std::vector<std::array<Across, 3>> across(mesh.triangles.size());
  forEachEdge(halfEdgesOf(mesh), [&](auto begin, auto end) {
    if (end - begin != 2) return;
    const HalfEdge &a = begin[0], &b = begin[1];
    across[a.triangle][a.corner] = {b.triangle, a.rises == b.rises};
    across[b.triangle][b.corner] = {a.triangle, a.rises == b.rises};
  });
  return across;
}

/// Joins half edges of one edge in pairs that have the inside between them. Seen along the edge, with the angle
/// counting counterclockwise, the inside comes before a half edge that rises and after one that falls.
void joinRound(const TriangleMesh& mesh, std::vector<HalfEdge> round, Neighbours* neighbours) {
  const Vec3 from = mesh.vertices[round[0].low], along = (mesh.vertices[round[0].high] - from).normalized();
  const Vec3 x = along.unitOrthogonal(), y = along.cross(x);
  const auto angle = [&](const HalfEdge& edge) {
    const Vec3 to = mesh.vertices[mesh.triangles[edge.triangle][(edge.corner + 2) % 3]] - from;
    return std::atan2(y.dot(to), x.dot(to));
  };
  std::stable_sort(round.begin(), round.end(),
                   [&](const HalfEdge& a, const HalfEdge& b) { return angle(a) < angle(b); });
  for (std::size_t i = 0, unpaired = 0; round.size() > 1 && unpaired < round.size();) {
    const std::size_t next = (i + 1) % round.size();
    const HalfEdge a = round[i], b = round[next];
    if (a.rises || !b.rises) {
      i = next;
      ++unpaired;
      continue;
    }
    (*neighbours)[a.triangle][a.corner] = b.triangle;
    (*neighbours)[b.triangle][b.corner] = a.triangle;
    round.erase(round.begin() + static_cast<std::ptrdiff_t>(std::max(i, next)));
    round.erase(round.begin() + static_cast<std::ptrdiff_t>(std::min(i, next)));
    i = unpaired = 0;
  }
}

/// Which corner of the triangle a vertex is.
int cornerAt(const TriangleMesh& mesh, int triangle, int vertex) {
  const std::array<int, 3>& corners = mesh.triangles[triangle];
  return static_cast<int>(std::find(corners.begin(), corners.end(), vertex) - corners.begin());
}

}  // namespace

void orientAlike(TriangleMesh* mesh) {
  const std::vector<std::array<Across, 3>> across = simplyAcross(*mesh);
  constexpr int UNSEEN = -1;
  std::vector<int> turned(mesh->triangles.size(), UNSEEN);
  for (int first = 0; first < static_cast<int>(turned.size()); ++first) {
    if (turned[first] != UNSEEN) continue;
    std::vector<int> patch = {first};
    turned[first] = 0;
    std::ptrdiff_t count = 0;
    for (std::size_t i = 0; i < patch.size(); ++i) {
      count += turned[patch[i]];
      for (const Across& edge : across[patch[i]]) {
        if (edge.triangle == NO_NEIGHBOUR) continue;
        const int wanted = turned[patch[i]] ^ static_cast<int>(edge.disagrees);
        if (turned[edge.triangle] == UNSEEN) {
          turned[edge.triangle] = wanted;
          patch.push_back(edge.triangle);
        }
        if (turned[edge.triangle] != wanted)
          throw InputError("one side of its surface goes over into the other (allowed: surfaces that bound a solid)");
      }
    }
    const int other_way = 2 * count > static_cast<std::ptrdiff_t>(patch.size()) ? 1 : 0;
    for (const int t : patch)
      if (turned[t] != other_way) turnOver(&mesh->triangles[t]);
  }
}

Neighbours neighboursOf(const TriangleMesh& mesh) {
  Neighbours neighbours(mesh.triangles.size(), {NO_NEIGHBOUR, NO_NEIGHBOUR, NO_NEIGHBOUR});
  forEachEdge(halfEdgesOf(mesh), [&](auto begin, auto end) {
    if (end - begin > 1) joinRound(mesh, {begin, end}, &neighbours);
  });
  return neighbours;
}

void splitVertices(const Neighbours& neighbours, TriangleMesh* mesh) {
  const int corners = 3 * static_cast<int>(neighbours.size());
  DisjointSets rings(corners);
  for (int i = 0; i < corners; ++i) {
    const int t = i / 3, k = i % 3, other = neighbours[t][k];
    if (other == NO_NEIGHBOUR) continue;
    for (const int corner : {k, (k + 1) % 3})
      rings.join(3 * t + corner, 3 * other + cornerAt(*mesh, other, mesh->triangles[t][corner]));
  }
  std::vector<int> ring_of;
  std::vector<Vec3> vertices(static_cast<std::size_t>(rings.enumerate(&ring_of)));
  for (int i = 0; i < corners; ++i) {
    int& vertex = mesh->triangles[i / 3][i % 3];
    vertices[ring_of[i]] = mesh->vertices[vertex];
    vertex = ring_of[i];
  }
  mesh->vertices = std::move(vertices);
}

}  // namespace incision
