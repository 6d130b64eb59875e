#pragma once

#include <Eigen/Geometry>
#include <vector>

#include "incision/base/lists.h"
#include "incision/contact/contact_surface.h"

namespace incision {

/// Whether two boxes come closer to each other than `reach` [m] in each direction of space.
inline bool areClose(const Eigen::AlignedBox3d& a, const Eigen::AlignedBox3d& b, double reach) {
  return (a.min().array() <= b.max().array() + reach).all() && (b.min().array() <= a.max().array() + reach).all();
}

/// Trees of boxes round the triangles of each piece. Their shape is that of the body at rest, and stays until the
/// surface changes; where the boxes are is found anew for the pieces that are looked at.
class PieceTrees {
 public:
  void build(const ContactSurface& surface);

  /// Puts the boxes of a piece where its vertices are.
  void place(const ContactSurface& surface, const std::vector<Vec3>& x, int piece);

  /// Calls f(triangle of a, triangle of b) where the boxes of two triangles are close by `reach` [m]. With a = b it is
  /// called once for each two triangles, and for each with itself.
  template <typename Function>
  void forEachClose(int a, int b, double reach, const Function& f) const;

 private:
  struct Node {
    Eigen::AlignedBox3d box;
    int begin, end;     // of the triangles in order_
    int children = -1;  // two nodes from there on; −1: a leaf
  };

  void split(const std::vector<Vec3>& centres, int node);

  std::vector<int> order_;                  // triangles, so that those of a node lie together
  std::vector<Eigen::AlignedBox3d> boxes_;  // of the triangles, in that order
  std::vector<Node> nodes_;                 // those of a piece together, parents before their children
  std::vector<int> start_;                  // the first node of each piece, which is its root
};

template <typename Function>
void PieceTrees::forEachClose(int a, int b, double reach, const Function& f) const {
  if (start_[a] == start_[a + 1] || start_[b] == start_[b + 1]) return;
  std::vector<std::pair<int, int>> open = {{start_[a], start_[b]}};
  while (!open.empty()) {
    const auto [i, k] = open.back();
    open.pop_back();
    const Node &m = nodes_[i], &n = nodes_[k];
    if (!areClose(m.box, n.box, reach)) continue;
    if (m.children < 0 && n.children < 0) {
      for (int s = m.begin; s < m.end; ++s)
        for (int t = i == k ? s : n.begin; t < n.end; ++t)
          if (areClose(boxes_[s], boxes_[t], reach)) f(order_[s], order_[t]);
    } else if (i == k) {
      open.insert(open.end(),
                  {{m.children, m.children}, {m.children, m.children + 1}, {m.children + 1, m.children + 1}});
    } else if (n.children < 0 || (m.children >= 0 && m.end - m.begin >= n.end - n.begin)) {
      open.insert(open.end(), {{m.children, k}, {m.children + 1, k}});
    } else {
      open.insert(open.end(), {{i, n.children}, {i, n.children + 1}});
    }
  }
}

}  // namespace incision
