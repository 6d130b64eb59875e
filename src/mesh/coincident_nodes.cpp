#include "coincident_nodes.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <cstdint>
#include <unordered_map>
#include <vector>

#include "incision/base/disjoint_sets.h"

namespace incision {
namespace {

/// Nodes are at one place when they are nearer than this fraction of the mesh's size: gmsh's Geometry.Tolerance, by
/// which `Coherence Mesh` joins them. Far less than the shortest edge it must be too, where the mesh has strays.
constexpr double SAME_PLACE = 1e-8, SHARE_OF_EDGE = 1e-3;

/// What doubles can tell apart, as a fraction of the largest coordinate.
constexpr double ROUNDING = 1e-15;

/// Cells of a grid of this many times the distance: most nodes then have neighbours in their own cell alone.
constexpr double CELL = 16;

using Cell = std::array<std::int64_t, 3>;

struct CellHash {
  std::size_t operator()(const Cell& cell) const {
    std::uint64_t hash = 0;
    for (std::int64_t i : cell) hash = (hash ^ static_cast<std::uint64_t>(i)) * 0x9E3779B97F4A7C15U;
    return static_cast<std::size_t>(hash ^ (hash >> 32));
  }
};

/// The part of each node, by nodes that elements share; −1 where no element uses the node.
std::vector<int> partOfNodes(const TetMesh& mesh) {
  DisjointSets sets(static_cast<int>(mesh.nodes.size()));
  std::vector<int> part_of(mesh.nodes.size(), -1);
  for (const auto& element : mesh.elements)
    for (int n : element) sets.join(element[0], n);
  for (const auto& element : mesh.elements)
    for (int n : element) part_of[n] = sets.lowest(n);
  return part_of;
}

bool areOnePart(const std::vector<int>& part_of) {
  int first = -1;
  for (int part : part_of) {
    if (part < 0) continue;
    if (first < 0) first = part;
    if (part != first) return false;
  }
  return true;
}

/// How near [m] two nodes are at one place.
double distanceOfOnePlace(const TetMesh& mesh, const std::vector<int>& part_of) {
  Eigen::AlignedBox3d box;
  for (std::size_t n = 0; n < mesh.nodes.size(); ++n)
    if (part_of[n] >= 0) box.extend(mesh.nodes[n]);
  const std::vector<double> edges = shortestEdges(mesh);
  const double shortest = *std::min_element(edges.begin(), edges.end());
  const double largest = std::max(box.min().cwiseAbs().maxCoeff(), box.max().cwiseAbs().maxCoeff());
  return std::max(std::min(SAME_PLACE * box.diagonal().norm(), SHARE_OF_EDGE * shortest), ROUNDING * largest);
}

class Places {
 public:
  Places(const TetMesh& mesh, const std::vector<int>& part_of, double distance)
      : mesh_(mesh), part_of_(part_of), distance_(distance) {}

  /// A node of another part at the place of this one among those added, or −1.
  int otherAt(int node) const {
    const Vec3& X = mesh_.nodes[node];
    const Cell low = cellOf(X - Vec3::Constant(distance_)), high = cellOf(X + Vec3::Constant(distance_));
    for (std::int64_t i = low[0]; i <= high[0]; ++i)
      for (std::int64_t j = low[1]; j <= high[1]; ++j)
        for (std::int64_t k = low[2]; k <= high[2]; ++k) {
          const auto [first, last] = nodes_.equal_range(Cell{i, j, k});
          for (auto at = first; at != last; ++at)
            if (part_of_[at->second] != part_of_[node] && (mesh_.nodes[at->second] - X).norm() <= distance_)
              return at->second;
        }
    return -1;
  }

  void add(int node) { nodes_.emplace(cellOf(mesh_.nodes[node]), node); }

 private:
  Cell cellOf(const Vec3& X) const {
    Cell cell;
    for (int i = 0; i < 3; ++i) cell[i] = static_cast<std::int64_t>(std::floor(X[i] / (CELL * distance_)));
    return cell;
  }

  const TetMesh& mesh_;
  const std::vector<int>& part_of_;
  const double distance_;
  std::unordered_multimap<Cell, int, CellHash> nodes_;
};

}  // namespace

CoincidentNodes findCoincidentNodes(const TetMesh& mesh) {
  CoincidentNodes found;
  const std::vector<int> part_of = partOfNodes(mesh);
  if (areOnePart(part_of)) return found;
  Places places(mesh, part_of, distanceOfOnePlace(mesh, part_of));
  for (int n = 0; n < static_cast<int>(mesh.nodes.size()); ++n) {
    if (part_of[n] < 0) continue;
    const int other = places.otherAt(n);
    if (other >= 0 && ++found.count == 1) found.pair = {other, n};
    places.add(n);
  }
  return found;
}

}  // namespace incision
