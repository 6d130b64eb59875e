#include "incision/rigid/closed_mesh.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <sstream>
#include <unordered_map>

#include "half_edges.h"
#include "incision/base/disjoint_sets.h"
#include "incision/base/input_error.h"
#include "incision/base/lists.h"

namespace incision {
namespace {

double extentOf(const TriangleMesh& mesh) {
  Eigen::AlignedBox3d box;
  for (const Vec3& vertex : mesh.vertices) box.extend(vertex);
  return box.isEmpty() ? 0 : box.sizes().maxCoeff();
}

/// For each vertex the first that is nearer than `tolerance`, maybe itself. Cells are twice as wide as that, so that
/// what is near lies in one of the eight cells round the nearest corner of cells.
std::vector<int> firstAlike(const std::vector<Vec3>& vertices, double tolerance) {
  using Cell = std::array<std::int64_t, 3>;
  const auto hash = [](const Cell& cell) {
    std::uint64_t sum = 0;
    for (const std::int64_t i : cell) sum = (sum ^ static_cast<std::uint64_t>(i)) * 0x9e3779b97f4a7c15U;
    return static_cast<std::size_t>(sum ^ (sum >> 32));
  };
  std::unordered_map<Cell, std::vector<int>, decltype(hash)> cells(vertices.size(), hash);
  const Vec3 origin = vertices.empty() ? Vec3(Vec3::Zero()) : vertices[0];
  const auto cellOf = [&](const Vec3& point) {
    const Vec3 at = ((point - origin) / (2 * tolerance)).array().floor();
    return Cell{static_cast<std::int64_t>(at.x()), static_cast<std::int64_t>(at.y()),
                static_cast<std::int64_t>(at.z())};
  };
  std::vector<int> alike(vertices.size());
  for (int v = 0; v < static_cast<int>(vertices.size()); ++v) {
    alike[v] = v;
    for (int corner = 0; corner < 8 && alike[v] == v; ++corner) {
      const Vec3 side(corner & 1 ? 1 : -1, corner & 2 ? 1 : -1, corner & 4 ? 1 : -1);
      const auto found = cells.find(cellOf(vertices[v] + tolerance * side));
      if (found == cells.end()) continue;
      for (const int other : found->second)
        if ((vertices[other] - vertices[v]).norm() < tolerance) alike[v] = std::min(alike[v], other);
    }
    if (alike[v] == v) cells[cellOf(vertices[v])].push_back(v);
  }
  return alike;
}

/// The mesh with one vertex where several are alike, without triangles that are there twice or have no three corners.
TriangleMesh welded(const TriangleMesh& mesh, double tolerance) {
  const std::vector<int> alike = firstAlike(mesh.vertices, tolerance);
  std::vector<std::pair<std::array<int, 3>, int>> sorted;  // corners, and which triangle they are
  TriangleMesh all{mesh.vertices, {}};
  for (const auto& [a, b, c] : mesh.triangles) {
    std::array<int, 3> corners = {alike[a], alike[b], alike[c]};
    const int index = static_cast<int>(all.triangles.size());
    all.triangles.push_back(corners);
    std::sort(corners.begin(), corners.end());
    if (corners[0] != corners[1] && corners[1] != corners[2]) sorted.emplace_back(corners, index);
  }
  std::sort(sorted.begin(), sorted.end());
  const auto end =
      std::unique(sorted.begin(), sorted.end(), [](const auto& a, const auto& b) { return a.first == b.first; });
  std::vector<int> kept;
  for (auto it = sorted.begin(); it != end; ++it) kept.push_back(it->second);
  std::sort(kept.begin(), kept.end());
  TriangleMesh once{mesh.vertices, {}};
  for (const int t : kept) once.triangles.push_back(all.triangles[t]);
  return once;
}

/// What was mended.
struct Mended {
  int holes = 0, sheets = 0;
  double widest = 0;  // of the holes [m]

  std::string remark() const {
    std::ostringstream text;
    if (holes > 0) text << holes << (holes == 1 ? " hole" : " holes") << " closed, the widest " << widest << " m";
    if (holes > 0 && sheets > 0) text << "; ";
    if (sheets > 0) text << sheets << (sheets == 1 ? " sheet" : " sheets") << " left out, which enclosed nothing";
    return text.str();
  }
};

/// Closes the hole with this rim, along which the triangles beside it go.
void closeHole(const std::vector<int>& rim, TriangleMesh* mesh, Mended* mended) {
  Eigen::AlignedBox3d box;
  Vec3 mean = Vec3::Zero();
  for (const int v : rim) {
    box.extend(mesh->vertices[v]);
    mean += mesh->vertices[v] / static_cast<double>(rim.size());
  }
  ++mended->holes;
  mended->widest = std::max(mended->widest, box.sizes().norm());
  if (rim.size() == 3) {
    mesh->triangles.push_back({rim[2], rim[1], rim[0]});
    return;
  }
  const int centre = static_cast<int>(mesh->vertices.size());
  mesh->vertices.push_back(mean);
  for (std::size_t i = 0; i < rim.size(); ++i) mesh->triangles.push_back({rim[(i + 1) % rim.size()], rim[i], centre});
}

/// Vertices have been split, so that every rim passes a vertex once.
void closeHoles(const Neighbours& neighbours, TriangleMesh* mesh, Mended* mended) {
  std::map<int, int> next;  // along rims
  for (std::size_t t = 0; t < neighbours.size(); ++t)
    for (int k = 0; k < 3; ++k)
      if (neighbours[t][k] == NO_NEIGHBOUR) next[mesh->triangles[t][k]] = mesh->triangles[t][(k + 1) % 3];
  while (!next.empty()) {
    std::vector<int> rim;
    for (auto at = next.begin(); at != next.end(); at = next.find(rim.back())) {
      rim.push_back(at->second);
      next.erase(at);
    }
    closeHole(rim, mesh, mended);
  }
}

struct Measure {
  double volume = 0, area = 0;  // [m³], [m²]
};

std::vector<Measure> measured(const TriangleMesh& mesh, const std::vector<int>& shell_of, int shells) {
  std::vector<Measure> measures(static_cast<std::size_t>(shells));
  std::vector<int> first(measures.size(), -1);  // vertex of each, from where volumes are measured
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
    const auto& [a, b, c] = mesh.triangles[t];
    int& from = first[shell_of[t]];
    if (from < 0) from = a;
    const Vec3 origin = mesh.vertices[from];
    const Vec3 x = mesh.vertices[a] - origin, y = mesh.vertices[b] - origin, z = mesh.vertices[c] - origin;
    measures[shell_of[t]].volume += x.dot(y.cross(z)) / 6;
    measures[shell_of[t]].area += (y - x).cross(z - x).norm() / 2;
  }
  return measures;
}

/// The shells that enclose something, turned outwards. A sheet is thinner than `tolerance`.
ClosedMesh shellsOf(const TriangleMesh& mesh, const Neighbours& neighbours, double tolerance, Mended* mended) {
  DisjointSets sets(static_cast<int>(mesh.triangles.size()));
  for (int t = 0; t < static_cast<int>(neighbours.size()); ++t)
    for (const int other : neighbours[t]) sets.join(t, other);
  std::vector<int> shell_of;
  const int shells = sets.enumerate(&shell_of);
  const std::vector<Measure> measures = measured(mesh, shell_of, shells);
  ClosedMesh closed;
  closed.vertices = mesh.vertices;
  closed.shell_start = {0};
  std::vector<int> place(mesh.triangles.size());
  const Lists<int> triangles = sortedByList(shell_of, shells);
  for (int s = 0; s < shells; ++s) {
    const auto& [volume, area] = measures[s];
    if (!(2 * std::abs(volume) > tolerance * area)) {
      ++mended->sheets;
      continue;
    }
    for (const int t : triangles[s]) {
      place[t] = static_cast<int>(closed.triangles.size());
      auto [a, b, c] = mesh.triangles[t];
      auto [ab, bc, ca] = neighbours[t];
      closed.triangles.push_back(volume > 0 ? std::array<int, 3>{a, b, c} : std::array<int, 3>{a, c, b});
      closed.neighbours.push_back(volume > 0 ? std::array<int, 3>{ab, bc, ca} : std::array<int, 3>{ca, bc, ab});
    }
    closed.shell_start.push_back(static_cast<int>(closed.triangles.size()));
  }
  for (std::array<int, 3>& across : closed.neighbours)
    for (int& t : across) t = place[t];
  return closed;
}

bool isClosed(const Neighbours& neighbours) {
  return std::all_of(neighbours.begin(), neighbours.end(), [](const std::array<int, 3>& across) {
    return std::find(across.begin(), across.end(), NO_NEIGHBOUR) == across.end();
  });
}

}  // namespace

ClosedMesh closeMesh(const TriangleMesh& mesh, std::string* remark) {
  const double tolerance = ALIKE * extentOf(mesh);
  if (!(tolerance > 0) || !std::isfinite(tolerance)) throw InputError("has no extent (allowed: surfaces of a solid)");
  TriangleMesh mended_mesh = welded(mesh, tolerance);
  Mended mended;
  orientAlike(&mended_mesh);
  Neighbours neighbours = neighboursOf(mended_mesh);
  splitVertices(neighbours, &mended_mesh);
  if (!isClosed(neighbours)) {
    closeHoles(neighbours, &mended_mesh, &mended);
    neighbours = neighboursOf(mended_mesh);
    splitVertices(neighbours, &mended_mesh);
  }
  if (!isClosed(neighbours)) throw InputError("is not closed (allowed: surfaces that bound a solid)");
  ClosedMesh closed = shellsOf(mended_mesh, neighbours, tolerance, &mended);
  if (closed.shells() == 0) throw InputError("encloses nothing (allowed: surfaces that bound a solid)");
  if (closed.shells() > MAX_SHELLS) {
    throw InputError("has " + std::to_string(closed.shells()) + " separate surfaces (allowed: up to " +
                     std::to_string(MAX_SHELLS) + ")");
  }
  *remark = mended.remark();
  return closed;
}

}  // namespace incision
