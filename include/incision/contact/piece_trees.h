#pragma once

#include <Eigen/Geometry>
#include <array>
#include <limits>
#include <utility>
#include <vector>

#include "incision/base/lists.h"
#include "incision/contact/contact_surface.h"

namespace incision {

/// Whether two boxes come closer to each other than `reach` [m] in each direction of space.
inline bool areClose(const Eigen::AlignedBox3d& a, const Eigen::AlignedBox3d& b, double reach) {
  return (a.min().array() <= b.max().array() + reach).all() && (b.min().array() <= a.max().array() + reach).all();
}

/// Round a triangle, with the vertices at `x` [m].
inline Eigen::AlignedBox3d boxOf(const ContactSurface& surface, const std::vector<Vec3>& x, int triangle) {
  const auto& [a, b, c] = surface.surface->triangles[triangle];
  return Eigen::AlignedBox3d(x[a]).extend(x[b]).extend(x[c]);
}

/// Round an edge.
inline Eigen::AlignedBox3d boxOf(const ContactSurface::Edge& edge, const std::vector<Vec3>& x) {
  return Eigen::AlignedBox3d(x[edge.from]).extend(x[edge.to]);
}

/// Trees of boxes round the triangles of each piece, and round the samples and the edges that these stand for. Their
/// shape is that of the body at rest, and stays until the surface changes; where the boxes are is found anew for the
/// pieces that are looked at.
class PieceTrees {
 public:
  void build(const ContactSurface& surface);

  /// Puts the boxes of a piece where its vertices are.
  void place(const ContactSurface& surface, const std::vector<Vec3>& x, int piece);

  /// Two nodes of which the samples of the one are to be compared with the triangles of the other, or the edges of
  /// both.
  struct Share {
    bool of_edges;
    int one, other;
  };

  /// What there is to compare of two pieces, divided into some shares that can be looked at each by itself, `most` or a
  /// few more: samples of each with triangles of the other, and edges with edges; or samples and triangles of a piece
  /// itself. What is not in one of them together does not come close by `reach` [m].
  std::vector<Share> shares(int a, int b, double reach, std::size_t most) const;

  /// Calls f(sample, triangle) or f(edge, edge) once for each two of a share whose boxes are close by `reach` [m].
  template <typename Function>
  void forEachClose(const Share& share, double reach, const Function& f) const;

  /// Calls f(triangle) for triangles of a piece that has been placed, the likely nearest to p first, as long as their
  /// boxes may come closer to p than it has returned last: the square of a distance [m²].
  template <typename Function>
  void forEachNear(int piece, const Vec3& p, const Function& f) const;

 private:
  /// More than a tree of 2³¹ triangles has levels, since nodes are halved.
  static constexpr int DEPTH = 32;

  struct Node {
    Eigen::AlignedBox3d box, points, lines;  // round the triangles, the samples, the edges
    int begin, end;                          // of the triangles in order_
    int children = -1;                       // two nodes from there on; −1: a leaf
  };

  void split(const std::vector<Vec3>& centres, int node);
  void placeLeaf(const ContactSurface& surface, const std::vector<Vec3>& x, Node* node);
  bool areClose(const Share& share, double reach) const;
  bool divide(const Share& share, std::vector<Share>* open) const;

  std::vector<int> order_;                  // triangles, so that those of a node lie together
  std::vector<Eigen::AlignedBox3d> boxes_;  // of the triangles, in that order
  Lists<int> samples_, edges_;              // that the triangles stand for, in that order
  std::vector<Vec3> points_;                // where the samples are, in the order of samples_.values() [m]
  std::vector<Eigen::AlignedBox3d> lines_;  // of the edges, in the order of edges_.values()
  std::vector<Node> nodes_;                 // those of a piece together, parents before their children
  std::vector<int> start_;                  // the first node of each piece, which is its root
};

template <typename Function>
void PieceTrees::forEachClose(const Share& share, double reach, const Function& f) const {
  std::vector<Share> open = {share};
  while (!open.empty()) {
    const Share at = open.back();
    open.pop_back();
    if (!areClose(at, reach) || divide(at, &open)) continue;
    const Node &m = nodes_[at.one], &n = nodes_[at.other];
    if (at.of_edges) {
      for (int e = edges_.start(m.begin); e < edges_.start(m.end); ++e)
        for (int k = edges_.start(n.begin); k < edges_.start(n.end); ++k)
          if (incision::areClose(lines_[e], lines_[k], reach)) f(edges_.values()[e], edges_.values()[k]);
      continue;
    }
    for (int s = samples_.start(m.begin); s < samples_.start(m.end); ++s)
      for (int t = n.begin; t < n.end; ++t)
        if (incision::areClose(Eigen::AlignedBox3d(points_[s]), boxes_[t], reach)) f(samples_.values()[s], order_[t]);
  }
}

template <typename Function>
void PieceTrees::forEachNear(int piece, const Vec3& p, const Function& f) const {
  double within = std::numeric_limits<double>::infinity();
  std::array<int, 2 * DEPTH> open;
  std::size_t count = 0;
  if (start_[piece] < start_[piece + 1]) open[count++] = start_[piece];
  while (count > 0) {
    const Node& node = nodes_[open[--count]];
    if (node.box.squaredExteriorDistance(p) > within) continue;
    if (node.children < 0) {
      for (int k = node.begin; k < node.end; ++k)
        if (boxes_[k].squaredExteriorDistance(p) <= within) within = f(order_[k]);
      continue;
    }
    const auto distance = [&](int child) { return nodes_[child].box.squaredExteriorDistance(p); };
    const bool second_is_nearer = distance(node.children + 1) < distance(node.children);
    open[count++] = node.children + (second_is_nearer ? 0 : 1);
    open[count++] = node.children + (second_is_nearer ? 1 : 0);
  }
}

}  // namespace incision
