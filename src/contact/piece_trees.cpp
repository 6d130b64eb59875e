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
    nodes_.push_back({{}, {}, {}, of_piece.start(piece), of_piece.start(piece + 1)});
    for (int node = start_.back(); node < static_cast<int>(nodes_.size()); ++node) split(centres, node);
  }
  start_.push_back(static_cast<int>(nodes_.size()));
  std::vector<int> place(order_.size());  // of each triangle in order_
  for (std::size_t i = 0; i < order_.size(); ++i) place[order_[i]] = static_cast<int>(i);
  samples_.sort(static_cast<int>(order_.size()), [&](const auto& add) {
    for (std::size_t s = 0; s < surface.samples.size(); ++s)
      add(place[surface.around[surface.samples[s].first]], static_cast<int>(s));
  });
  edges_.sort(static_cast<int>(order_.size()), [&](const auto& add) {
    for (std::size_t e = 0; e < surface.edges.size(); ++e) add(place[surface.edges[e].triangle], static_cast<int>(e));
  });
  points_.resize(samples_.values().size());
  lines_.resize(edges_.values().size());
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
  nodes_.push_back({{}, {}, {}, begin, middle});
  nodes_.push_back({{}, {}, {}, middle, end});
}

bool PieceTrees::areClose(const Share& share, double reach) const {
  const Node &m = nodes_[share.one], &n = nodes_[share.other];
  return share.of_edges ? incision::areClose(m.lines, n.lines, reach) : incision::areClose(m.points, n.box, reach);
}

/// Puts the shares that children make in the place of a share; returns false where both nodes are leaves.
bool PieceTrees::divide(const Share& share, std::vector<Share>* open) const {
  const Node &m = nodes_[share.one], &n = nodes_[share.other];
  if (m.children < 0 && n.children < 0) return false;
  for (int child = 0; child < 2; ++child)
    if (n.children < 0 || (m.children >= 0 && m.end - m.begin >= n.end - n.begin))
      open->push_back({share.of_edges, m.children + child, share.other});
    else
      open->push_back({share.of_edges, share.one, n.children + child});
  return true;
}

std::vector<PieceTrees::Share> PieceTrees::shares(int a, int b, double reach, std::size_t most) const {
  std::vector<Share> found;
  if (start_[a] == start_[a + 1] || start_[b] == start_[b + 1]) return found;
  found.push_back({false, start_[a], start_[b]});
  if (a != b) found.insert(found.end(), {{false, start_[b], start_[a]}, {true, start_[a], start_[b]}});
  for (std::size_t next = 0; next < found.size() && found.size() - next < most;) {
    const Share share = found[next];
    if (areClose(share, reach) && !divide(share, &found)) {
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
    if (node.children < 0) {
      placeLeaf(surface, x, &node);
      continue;
    }
    const Node &one = nodes_[node.children], &other = nodes_[node.children + 1];
    node.box = one.box.merged(other.box);
    node.points = one.points.merged(other.points);
    node.lines = one.lines.merged(other.lines);
  }
}

void PieceTrees::placeLeaf(const ContactSurface& surface, const std::vector<Vec3>& x, Node* node) {
  for (auto* box : {&node->box, &node->points, &node->lines}) box->setEmpty();
  for (int k = node->begin; k < node->end; ++k) {
    boxes_[k] = boxOf(surface, x, order_[k]);
    node->box.extend(boxes_[k]);
  }
  for (int s = samples_.start(node->begin); s < samples_.start(node->end); ++s) {
    points_[s] = x[surface.samples[samples_.values()[s]].vertex];
    node->points.extend(points_[s]);
  }
  for (int e = edges_.start(node->begin); e < edges_.start(node->end); ++e) {
    lines_[e] = boxOf(surface.edges[edges_.values()[e]], x);
    node->lines.extend(lines_[e]);
  }
}

}  // namespace incision
