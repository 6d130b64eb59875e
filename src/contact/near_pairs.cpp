#include "incision/contact/near_pairs.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <tuple>
#include <utility>

#include "incision/base/parallel.h"
#include "incision/base/sort_once.h"
#include "incision/contact/skin_in_step.h"

namespace incision {
namespace {

/// How far, in elements, a search looks beyond its reach: less and it comes often, more and each step has more to look
/// through.
constexpr double FURTHER = 0.12;

/// And for a piece and itself, which mostly has nothing near.
constexpr double FURTHER_IN_ONE = 0.5;

/// Shares of the search of one pair.
constexpr std::size_t SHARES = 16;

/// A piece's shape is taken anew when a vertex is off by more than this share of that.
constexpr double SHAPE_SHARE = 0.2;

/// What a search looks further for pieces that turn together: between the two ends of a step their points go straight,
/// and so nearer to each other than they are at either end, by up to so much with a turn of a radian.
constexpr double TURNING = 1.15;

/// At rest closer than this, in elements, two points of a piece are neighbours, and what lies behind is material.
constexpr double NEAR_AT_REST = 3;

/// Gaps at rest, in elements, that are rounding: faces born together.
constexpr double SAME_PLANE = 1e-6;

/// At rest closer than this, in elements, two points of one flat side do not meet: it would have to fold in between.
constexpr double BESIDE_AT_REST = 1.5;

/// The cosine of the angle between triangles of one flat side is more.
constexpr double ONE_SIDE = 0.7;

/// Whether a sample and a triangle of one piece never meet: there was material in between at rest, behind the triangle,
/// or they lie beside each other.
bool staysApart(const ContactSurface& surface, const ContactSurface::Sample& sample, int triangle) {
  const Vec3 from = surface.rest[sample.vertex] - surface.rest[surface.surface->triangles[triangle][0]];
  const double size = surface.size[sample.vertex], distance = from.norm();
  if (distance >= NEAR_AT_REST * size) return false;
  const Vec3 N = restArea(surface, triangle);
  if (N.dot(from) < -SAME_PLANE * size * N.norm()) return true;
  const Vec3 M = restArea(surface, surface.around[sample.first]);
  return distance < BESIDE_AT_REST * size && N.dot(M) > ONE_SIDE * N.norm() * M.norm();
}

/// Whether a point is at most so far from a triangle's plane [m], and as seen along its normal beside no edge by more
/// than `aside` [m] and the triangle's rim.
bool isAbove(const std::array<Vec3, 3>& triangle, const Vec3& p, double further, double aside) {
  const auto& [a, b, c] = triangle;
  const Vec3 n = (b - a).cross(c - a);
  const double square = n.squaredNorm(), length = std::sqrt(square);
  if (std::abs(n.dot(p - a)) > further * length) return false;
  for (int k = 0; k < 3; ++k) {
    const Vec3 &from = triangle[k], edge = triangle[(k + 1) % 3] - from;
    // The weight of the third corner times n², and what an edge so far away changes of that.
    if (edge.cross(p - from).dot(n) < -RIM * square - aside * edge.norm() * length) return false;
  }
  return true;
}

Eigen::AlignedBox3d boxOf(const ContactSurface::Edge& edge, const std::vector<Vec3>& x) {
  return Eigen::AlignedBox3d(x[edge.from]).extend(x[edge.to]);
}

}  // namespace

void NearPairs::surfaceChanged(const ContactSurface& surface) {
  frames_.surfaceChanged(surface);
  trees_.build(surface);
  const int triangles = static_cast<int>(surface.piece.size());
  has_area_.resize(triangles);
  for (int t = 0; t < triangles; ++t) has_area_[t] = hasAreaAtRest(surface, t);
  samples_of_.sort(triangles, [&](const auto& add) {
    for (std::size_t s = 0; s < surface.samples.size(); ++s)
      add(surface.around[surface.samples[s].first], static_cast<int>(s));
  });
  edges_of_.sort(triangles, [&](const auto& add) {
    for (std::size_t e = 0; e < surface.edges.size(); ++e) add(surface.edges[e].triangle, static_cast<int>(e));
  });
  base_margin_ = FURTHER * surface.mean_size;
  margin_of_one_ = FURTHER_IN_ONE * surface.mean_size;
  searches_ = 0;
  pairs_.clear();
  pairs_.resize(surface.pieces);
  active_.clear();
}

void NearPairs::update(const ContactSurface& surface, const std::vector<Vec3>& x, const std::vector<Vec3>& ahead,
                       double reach, int threads) {
  frames_.update(x, ahead, SHAPE_SHARE * base_margin_, threads);
  findClosePieces(reach);
  active_.clear();
  stale_.clear();
  to_place_.clear();
  for (const auto& [a, b] : close_) {
    std::vector<std::unique_ptr<Pair>>& of_a = pairs_[a];
    auto at =
        std::lower_bound(of_a.begin(), of_a.end(), b, [](const auto& pair, int piece) { return pair->b < piece; });
    if (at == of_a.end() || (*at)->b != b) {
      at = of_a.insert(at, std::make_unique<Pair>());
      (*at)->a = a;
      (*at)->b = b;
    }
    active_.push_back(at->get());
    if (needed(**at) < (*at)->margin) continue;
    stale_.push_back(at->get());
    to_place_.insert(to_place_.end(), {a, b});
  }
  sortOnce(&to_place_);
  placed_.assign(pairs_.size(), false);
  placeTrees(surface, x, to_place_, threads);
  shares_.clear();
  for (std::size_t i = 0; i < stale_.size(); ++i) startSearch(reach, i);
  searchShares(surface, x, threads);
  searches_ += static_cast<int>(stale_.size());
}

const PieceTrees& NearPairs::placeTrees(const ContactSurface& surface, const std::vector<Vec3>& x,
                                        const std::vector<int>& pieces, int threads) {
  parallelFor(static_cast<int>(pieces.size()), threads, [&](int i) {
    if (!std::exchange(placed_[pieces[i]], true)) trees_.place(surface, x, pieces[i]);
  });
  return trees_;
}

const PieceTrees& NearPairs::placeTreesElsewhere(const ContactSurface& surface, const std::vector<Vec3>& x,
                                                 const std::vector<int>& pieces, int threads) {
  placed_.assign(pairs_.size(), false);
  placeTrees(surface, x, pieces, threads);
  placed_.assign(pairs_.size(), false);
  return trees_;
}

/// The pieces whose ways in the step come within reach of each other: those that begin along x before another ends.
void NearPairs::findClosePieces(double reach) {
  const std::vector<PieceFrames::Piece>& pieces = frames_.pieces();
  sweep_.clear();
  for (std::size_t p = 0; p < pieces.size(); ++p)
    if (!pieces[p].way.isEmpty()) sweep_.emplace_back(pieces[p].way.min().x(), static_cast<int>(p));
  std::sort(sweep_.begin(), sweep_.end());
  close_.clear();
  double widest = 0;
  for (const PieceFrames::Piece& piece : pieces) widest = std::max(widest, reach * piece.size);
  for (std::size_t i = 0; i < sweep_.size(); ++i) {
    const int a = sweep_[i].second;
    close_.emplace_back(a, a);
    for (std::size_t k = i + 1; k < sweep_.size() && sweep_[k].first <= pieces[a].way.max().x() + widest; ++k) {
      const int b = sweep_[k].second;
      const double near = reach * std::max(pieces[a].size, pieces[b].size);
      if (areClose(pieces[a].way, pieces[b].way, near)) close_.emplace_back(std::min(a, b), std::max(a, b));
    }
  }
  std::sort(close_.begin(), close_.end());
}

/// How far points of the two can have moved relative to each other since the search, by the end of the step [m].
double NearPairs::needed(const Pair& pair) const {
  const PieceFrames::Piece &a = frames_.pieces()[pair.a], &b = frames_.pieces()[pair.b];
  double most = 0;
  for (int end = 0; end < 2; ++end) {
    const double rigid = pair.a == pair.b ? 0 : movedApart(a, b, pair.from_a, pair.from_b, end);
    most = std::max(most, rigid + a.off[end] + b.off[end]);
  }
  return most + pair.off + a.worn + b.worn - pair.worn;
}

/// Divides the search of a pair, which may be the only one, into shares.
void NearPairs::startSearch(double reach, std::size_t stale) {
  Pair* const pair = stale_[stale];
  const PieceFrames::Piece &a = frames_.pieces()[pair->a], &b = frames_.pieces()[pair->b];
  pair->faces.clear();
  pair->edges.clear();
  pair->from_a = a.frames[0];
  pair->from_b = b.frames[0];
  pair->worn = a.worn + b.worn;
  pair->off = a.off[0] + b.off[0];
  pair->margin = (pair->a == pair->b ? margin_of_one_ : base_margin_) + needed(*pair);
  pair->further = TURNING * (reach * std::max(a.size, b.size) + pair->margin);
  pair->aside = TURNING * pair->margin;
  for (const PieceTrees::Share& nodes : trees_.shares(pair->a, pair->b, pair->further, SHARES))
    shares_.push_back({stale, nodes, {}, {}});
}

/// What all find together is sorted, so it makes no difference how it was divided.
void NearPairs::searchShares(const ContactSurface& surface, const std::vector<Vec3>& x, int threads) {
  parallelFor(static_cast<int>(shares_.size()), threads, [&](int i) {
    Share& share = shares_[i];
    const Pair& pair = *stale_[share.stale];
    trees_.forEachClose(share.nodes, pair.further, [&](int t, int other) {
      if (t == other) return;
      addClose(surface, x, pair, t, other, &share.faces);
      addClose(surface, x, pair, other, t, &share.faces);
      if (pair.a == pair.b) return;
      for (int e : edges_of_[t])
        for (int f : edges_of_[other])
          if (areClose(boxOf(surface.edges[e], x), boxOf(surface.edges[f], x), pair.further))
            share.edges.emplace_back(e, f);
    });
  });
  for (const Share& share : shares_) {
    Pair* const pair = stale_[share.stale];
    pair->faces.insert(pair->faces.end(), share.faces.begin(), share.faces.end());
    pair->edges.insert(pair->edges.end(), share.edges.begin(), share.edges.end());
  }
  parallelFor(static_cast<int>(stale_.size()), threads, [&](int i) {
    Pair* const pair = stale_[i];
    std::sort(pair->faces.begin(), pair->faces.end(), [](const SampleTriangle& s, const SampleTriangle& t) {
      return std::tie(s.sample, s.triangle) < std::tie(t.sample, t.triangle);
    });
    std::sort(pair->edges.begin(), pair->edges.end());
  });
}

/// Adds the samples that a triangle stands for and the other one, where they are above or below it, or may come there.
void NearPairs::addClose(const ContactSurface& surface, const std::vector<Vec3>& x, const Pair& pair, int t, int other,
                         std::vector<SampleTriangle>* faces) const {
  if (!has_area_[other]) return;
  const auto& [a, b, c] = surface.surface->triangles[other];
  for (int s : samples_of_[t]) {
    const int vertex = surface.samples[s].vertex;
    if (vertex == a || vertex == b || vertex == c) continue;
    const Vec3 lower = x[a].cwiseMin(x[b]).cwiseMin(x[c]), upper = x[a].cwiseMax(x[b]).cwiseMax(x[c]);
    if ((lower.array() > x[vertex].array() + pair.further).any() ||
        (upper.array() < x[vertex].array() - pair.further).any())
      continue;
    if (!isAbove({x[a], x[b], x[c]}, x[vertex], pair.further, pair.aside)) continue;
    if (pair.a != pair.b || !staysApart(surface, surface.samples[s], other)) faces->push_back({s, other});
  }
}

}  // namespace incision
