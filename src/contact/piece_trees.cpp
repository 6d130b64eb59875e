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
