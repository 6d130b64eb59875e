#include "incision/surface/gaps.h"

#include <algorithm>
#include <unordered_map>

namespace incision {
namespace {

/// The edges that remain when each is struck out together with one that runs the other way.
std::vector<SurfaceEdge> unmatchedEdges(const std::vector<SurfaceEdge>& edges, int num_vertices) {
  const auto lower = [](const SurfaceEdge& e) { return std::min(e.from, e.to); };
  std::vector<int> first(num_vertices, -1), next(edges.size());  // lists of open edges by their lower vertex
  for (std::size_t i = 0; i < edges.size(); ++i) {
    int* link = &first[lower(edges[i])];
    while (*link >= 0 && (edges[*link].from != edges[i].to || edges[*link].to != edges[i].from)) link = &next[*link];
    if (*link >= 0) {
      *link = next[*link];
    } else {
      next[i] = first[lower(edges[i])];
      first[lower(edges[i])] = static_cast<int>(i);
    }
  }
  std::vector<SurfaceEdge> unmatched;
  for (int open : first)
    for (; open >= 0; open = next[open]) unmatched.push_back(edges[open]);
  return unmatched;
}

}  // namespace

std::vector<std::vector<SurfaceEdge>> findGaps(const std::vector<SurfaceEdge>& edges, int num_vertices) {
  std::vector<std::vector<SurfaceEdge>> gaps;
  const std::vector<SurfaceEdge> unmatched = unmatchedEdges(edges, num_vertices);
  std::unordered_map<int, std::vector<SurfaceEdge>> leaving;
  for (const SurfaceEdge& edge : unmatched) leaving[edge.from].push_back(edge);

  // As many unmatched edges leave a vertex as reach it, so a walk along them only ends where it began.
  for (const SurfaceEdge& start : unmatched) {
    std::vector<SurfaceEdge> walk;
    for (int at = start.from; !leaving[at].empty();) {
      walk.push_back(leaving[at].back());
      leaving[at].pop_back();
      at = walk.back().to;
      const auto loop = std::find_if(walk.begin(), walk.end(), [at](const SurfaceEdge& e) { return e.from == at; });
      if (loop == walk.end()) continue;
      gaps.emplace_back(loop, walk.end());
      walk.erase(loop, walk.end());
    }
  }
  return gaps;
}

}  // namespace incision
