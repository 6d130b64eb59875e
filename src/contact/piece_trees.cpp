#include "incision/contact/piece_trees.h"

#include <algorithm>

namespace incision {
namespace {

/// Triangles of a leaf: with fewer the tree takes longer than what it saves.
constexpr int LEAF = 4;

}  // namespace

void PieceTrees::build(const ContactSurface& surface) {
  const auto& triangles = surface.surface->triangles;
  const Lists<int> of_piece = sortedByList(surface.piece, surface.pieces);
  std::vector<Vec3> centres;
  for (const auto& [a, b, c] : triangles) centres.push_back(surface.rest[a] + surface.rest[b] + surface.rest[c]);
  order_ = of_piece.values();
  boxes_.resize(order_.size());
  nodes_.clear();
  start_.clear();
  for (int piece = 0; piece < surface.pieces; ++piece) {
    start_.push_back(static_cast<int>(nodes_.size()));
    if (of_piece[piece].size() == 0) continue;
    nodes_.push_back({{}, of_piece.start(piece), of_piece.start(piece + 1)});
    for (int node = start_.back(); node < static_cast<int>(nodes_.size()); ++node) split(centres, node);
  }
  start_.push_back(static_cast<int>(nodes_.size()));
}

/// In halves across the longest way.
void PieceTrees::split(const std::vector<Vec3>& centres, int node) {
  const int begin = nodes_[node].begin, end = nodes_[node].end, middle = (begin + end) / 2;
  if (end - begin <= LEAF) return;
  Eigen::AlignedBox3d box;
  for (int i = begin; i < end; ++i) box.extend(centres[order_[i]]);
  int axis = 0;
  box.sizes().maxCoeff(&axis);
  std::nth_element(order_.begin() + begin, order_.begin() + middle, order_.begin() + end, [&](int a, int b) {
    return centres[a][axis] != centres[b][axis] ? centres[a][axis] < centres[b][axis] : a < b;
  });
  nodes_[node].children = static_cast<int>(nodes_.size());
  nodes_.push_back({{}, begin, middle});
  nodes_.push_back({{}, middle, end});
}

/// Puts the shares that children make in the place of a share; returns false where both nodes are leaves.
bool PieceTrees::divide(const Share& share, std::vector<Share>* open) const {
  const auto [i, k] = share;
  const Node &m = nodes_[i], &n = nodes_[k];
  if (m.children < 0 && n.children < 0) return false;
  if (i == k) {
    open->insert(open->end(),
                 {{m.children, m.children}, {m.children, m.children + 1}, {m.children + 1, m.children + 1}});
  } else if (n.children < 0 || (m.children >= 0 && m.end - m.begin >= n.end - n.begin)) {
    open->insert(open->end(), {{m.children, k}, {m.children + 1, k}});
  } else {
    open->insert(open->end(), {{i, n.children}, {i, n.children + 1}});
  }
  return true;
}

std::vector<PieceTrees::Share> PieceTrees::shares(int a, int b, double reach, std::size_t most) const {
  std::vector<Share> found;
  if (start_[a] == start_[a + 1] || start_[b] == start_[b + 1]) return found;
  found.emplace_back(start_[a], start_[b]);
  for (std::size_t next = 0; next < found.size() && found.size() - next < most;) {
    const Share share = found[next];
    if (areClose(nodes_[share.first].box, nodes_[share.second].box, reach) && !divide(share, &found)) {
      ++next;
    } else {
      found.erase(found.begin() + static_cast<std::ptrdiff_t>(next));
    }
  }
  return found;
}

void PieceTrees::place(const ContactSurface& surface, const std::vector<Vec3>& x, int piece) {
  for (int i = start_[piece + 1] - 1; i >= start_[piece]; --i) {
    Node& node = nodes_[i];
    node.box.setEmpty();
    if (node.children >= 0) {
      node.box = nodes_[node.children].box.merged(nodes_[node.children + 1].box);
      continue;
    }
    for (int k = node.begin; k < node.end; ++k) {
      boxes_[k].setEmpty();
      for (int v : surface.surface->triangles[order_[k]]) boxes_[k].extend(x[v]);
      node.box.extend(boxes_[k]);
    }
  }
}

}  // namespace incision
