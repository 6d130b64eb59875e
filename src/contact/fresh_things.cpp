#include "incision/contact/fresh_things.h"

#include <Eigen/Geometry>

#include "incision/contact/piece_trees.h"

namespace incision {
namespace {

/// The most that is little: each fresh thing is held against all things that come near any of them.
constexpr int LITTLE = 200;

std::vector<char> marked(const std::vector<int>& numbers, std::size_t count) {
  std::vector<char> marks(count, false);
  for (int i : numbers) marks[i] = true;
  return marks;
}

}  // namespace

void FreshThings::surfaceChanged(const ContactSurface& surface, const SurfaceMatch& known) {
  const auto pieceOfSample = [&](int s) { return surface.vertex_piece[surface.samples[s].vertex]; };
  const auto pieceOfEdge = [&](int e) { return surface.vertex_piece[surface.edges[e].from]; };
  const std::vector<char> is_fresh_sample = marked(known.new_samples, surface.samples.size());
  is_fresh_edge_ = marked(known.new_edges, surface.edges.size());
  triangles_.sort(surface.pieces, [&](const auto& add) {
    for (int t : known.new_triangles) add(surface.piece[t], t);
  });
  samples_.sort(surface.pieces, [&](const auto& add) {
    for (int s : known.new_samples) add(pieceOfSample(s), s);
  });
  edges_.sort(surface.pieces, [&](const auto& add) {
    for (int e : known.new_edges) add(pieceOfEdge(e), e);
  });
  all_triangles_ = sortedByList(surface.piece, surface.pieces);
  old_samples_.sort(surface.pieces, [&](const auto& add) {
    for (int s = 0; s < static_cast<int>(surface.samples.size()); ++s)
      if (!is_fresh_sample[s]) add(pieceOfSample(s), s);
  });
  all_edges_.sort(surface.pieces, [&](const auto& add) {
    for (int e = 0; e < static_cast<int>(surface.edges.size()); ++e) add(pieceOfEdge(e), e);
  });
}

bool FreshThings::isLittle(int piece) const { return count(piece) <= LITTLE; }

void FreshThings::addFaces(const ContactSurface& surface, const std::vector<Vec3>& x, int a, int b, const Reach& reach,
                           std::vector<SampleTriangle>* faces) const {
  const auto at = [&](int s) { return Eigen::AlignedBox3d(x[surface.samples[s].vertex]); };
  const auto add = [&](int s, int t, const Eigen::AlignedBox3d& box) {
    if (areClose(at(s), box, reach.further) && mayMeet(surface, x, s, t, reach, a == b)) faces->push_back({s, t});
  };
  Eigen::AlignedBox3d round_samples, round_triangles;
  for (int s : samples_[a]) round_samples.extend(at(s));
  for (int t : all_triangles_[b]) {
    const Eigen::AlignedBox3d box = boxOf(surface, x, t);
    if (!areClose(round_samples, box, reach.further)) continue;
    for (int s : samples_[a]) add(s, t, box);
  }
  for (int t : triangles_[b]) round_triangles.extend(boxOf(surface, x, t));
  for (int s : old_samples_[a]) {
    if (!areClose(round_triangles, at(s), reach.further)) continue;
    for (int t : triangles_[b]) add(s, t, boxOf(surface, x, t));
  }
}

void FreshThings::addEdges(const ContactSurface& surface, const std::vector<Vec3>& x, int a, int b, double further,
                           std::vector<std::pair<int, int>>* edges) const {
  const auto add = [&](int e, int f) {
    if (areClose(boxOf(surface.edges[e], x), boxOf(surface.edges[f], x), further)) edges->emplace_back(e, f);
  };
  for (int e : edges_[a])
    for (int f : all_edges_[b]) add(e, f);
  for (int f : edges_[b])
    for (int e : all_edges_[a])
      if (!is_fresh_edge_[e]) add(e, f);
}

}  // namespace incision
