#include <algorithm>
#include <array>

#include "incision/fem/patches.h"

namespace incision {
namespace {

/// Fewer elements round an edge do not make a cluster of their own.
constexpr int LEAST = 3;

/// A cluster has no more: its cost grows with the square. Meshes in use have up to ten elements round an edge.
constexpr int MOST = 12;

/// An edge and the elements of one region round it: elements[start] … elements[end − 1].
struct ElementEdge {
  double length;
  int start, end;
};

/// All edges, the longest first; `elements` gets what they refer to.
std::vector<ElementEdge> edgesByLength(const TetMesh& mesh, const Regions& regions, std::vector<int>* elements) {
  std::vector<std::array<int, 4>> sides;  // two nodes, a region and an element
  for (int e = 0; e < static_cast<int>(mesh.elements.size()); ++e)
    for (const auto& [i, j] : EDGE_NODES) {
      const auto [low, high] = std::minmax(mesh.elements[e][i], mesh.elements[e][j]);
      sides.push_back({low, high, regions.of(e), e});
    }
  std::sort(sides.begin(), sides.end());
  std::vector<ElementEdge> edges;
  for (std::size_t k = 0; k < sides.size(); ++k) {
    const auto& [i, j, region, e] = sides[k];
    if (k == 0 || sides[k - 1][0] != i || sides[k - 1][1] != j || sides[k - 1][2] != region)
      edges.push_back({(mesh.nodes[i] - mesh.nodes[j]).norm(), static_cast<int>(k), 0});
    edges.back().end = static_cast<int>(k) + 1;
    elements->push_back(e);
  }
  std::stable_sort(edges.begin(), edges.end(),
                   [](const ElementEdge& a, const ElementEdge& b) { return a.length > b.length; });
  return edges;
}

/// Gives every element that has no cluster to its smallest neighbour of the region; where all are full it is one by
/// itself.
void giveAwayRest(const MeshTopology& topology, const Regions& regions, std::vector<int> size,
                  std::vector<int>* cluster_of) {
  for (bool any = true; any;) {
    any = false;
    for (std::size_t e = 0; e < cluster_of->size(); ++e) {
      if ((*cluster_of)[e] >= 0) continue;
      int smallest = -1;
      for (int other : topology.neighbours[e]) {
        if (other < 0 || regions.of(other) != regions.of(static_cast<int>(e))) continue;
        const int cluster = (*cluster_of)[other];
        if (cluster >= 0 && size[cluster] < (smallest < 0 ? MOST : size[smallest])) smallest = cluster;
      }
      if (smallest < 0) continue;
      (*cluster_of)[e] = smallest;
      ++size[smallest];
      any = true;
    }
  }
  for (int& cluster : *cluster_of)
    if (cluster < 0) {
      cluster = static_cast<int>(size.size());
      size.push_back(1);
    }
}

}  // namespace

std::vector<int> edgeClusters(const TetMesh& mesh, const MeshTopology& topology, const Regions& regions) {
  std::vector<int> elements, cluster_of(mesh.elements.size(), -1), size;
  const std::vector<ElementEdge> edges = edgesByLength(mesh, regions, &elements);
  const auto countFree = [&](const ElementEdge& edge) {
    int count = 0;
    for (int k = edge.start; k < edge.end; ++k) count += cluster_of[elements[k]] < 0;
    return count;
  };
  for (int wanted = MOST; wanted >= LEAST; --wanted)
    for (const ElementEdge& edge : edges) {
      if (edge.end - edge.start < wanted || countFree(edge) != wanted) continue;
      for (int k = edge.start; k < edge.end; ++k)
        if (int& cluster = cluster_of[elements[k]]; cluster < 0) cluster = static_cast<int>(size.size());
      size.push_back(wanted);
    }
  giveAwayRest(topology, regions, size, &cluster_of);
  return cluster_of;
}

}  // namespace incision
