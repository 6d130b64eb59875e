#include "incision/contact/near_pairs.h"

#include <algorithm>
#include <tuple>
#include <utility>

#include "incision/base/parallel.h"
#include "incision/base/sort_once.h"

namespace incision {
namespace {

/// How far, in elements, a search looks beyond its reach: less and it comes often, more and each step has more to look
/// through.
constexpr double FURTHER = 0.12;

/// And for a piece and itself, which mostly has nothing near.
constexpr double FURTHER_IN_ONE = 0.5;

/// And in what such a search has found, for pieces that hardly move: at rest that leaves half to be looked at.
constexpr double FURTHER_AT_REST = 0.01;

/// Shares of the search of one pair.
constexpr std::size_t SHARES = 16;

/// A piece's shape is taken anew when a vertex is off by more than this share of that.
constexpr double SHAPE_SHARE = 0.2;

/// What a search looks further for pieces that turn together: between the two ends of a step their points go straight,
/// and so nearer to each other than they are at either end, by up to so much with a turn of a radian.
constexpr double TURNING = 1.15;

}  // namespace

/// Where memory runs out there is no pair, and what is known of the pieces is of one surface.
void NearPairs::surfaceChanged(const ContactSurface& surface, const std::vector<Vec3>& x) {
  Pairs before;
  before.swap(pairs_);
  active_.clear();
  SurfaceOutline outline(surface);
  const SurfaceMatch known = match(outline_, surface);
  PieceFrames close_frames;
  close_frames.surfaceChanged(surface, known, x);
  frames_.surfaceChanged(surface, known, x);
  close_frames_ = std::move(close_frames);
  outline_ = std::move(outline);
  fresh_.surfaceChanged(surface, known);
  has_trees_ = false;
  base_margin_ = FURTHER * surface.mean_size;
  margin_of_one_ = FURTHER_IN_ONE * surface.mean_size;
  narrow_margin_ = FURTHER_AT_REST * surface.mean_size;
  pairs_ = kept(&before, known);
}

/// The pairs of pieces that are still there, and have little that is fresh.
NearPairs::Pairs NearPairs::kept(Pairs* before, const SurfaceMatch& known) const {
  Pairs pairs(frames_.pieces().size());
  const auto isKept = [&](int piece) {
    return piece >= 0 && frames_.pieces()[piece].is_followed && fresh_.isLittle(piece);
  };
  for (auto& of_piece : *before)
    for (std::unique_ptr<Pair>& pair : of_piece) {
      if (!pair->is_searched || pair->is_incomplete || !isKept(known.pieces[pair->a]) || !isKept(known.pieces[pair->b]))
        continue;
      renumber(known, pair.get());
      pairs[pair->a].push_back(std::move(pair));
    }
  for (auto& of_piece : pairs)
    std::sort(of_piece.begin(), of_piece.end(), [](const auto& p, const auto& q) { return p->b < q->b; });
  return pairs;
}

void NearPairs::renumber(const SurfaceMatch& known, Pair* pair) const {
  pair->a = known.pieces[pair->a];
  pair->b = known.pieces[pair->b];
  std::vector<SampleTriangle> faces;
  for (const SampleTriangle& at : pair->near)
    if (const int s = known.samples[at.sample], t = known.triangles[at.triangle]; s >= 0 && t >= 0)
      faces.push_back({s, t});
  std::vector<std::pair<int, int>> edges;
  for (const auto& [e, f] : pair->edges)
    if (known.edges[e] >= 0 && known.edges[f] >= 0) edges.emplace_back(known.edges[e], known.edges[f]);
  pair->near = std::move(faces);
  pair->is_narrow = false;
  pair->edges = std::move(edges);
  if (pair->a > pair->b) {
    std::swap(pair->a, pair->b);
    pair->search.swapPieces();
    for (auto& [e, f] : pair->edges) std::swap(e, f);
  }
  // Larger elements reach further than was looked.
  const std::vector<PieceFrames::Piece>& pieces = frames_.pieces();
  const double grown = std::max(1.0, std::max(pieces[pair->a].size, pieces[pair->b].size) / pair->size);
  pair->search.lose((grown - 1) * pair->reach);
  pair->reach *= grown;
  pair->size *= grown;
  pair->is_incomplete = fresh_.any(pair->a) || fresh_.any(pair->b);
}

void NearPairs::update(const ContactSurface& surface, const std::vector<Vec3>& x, const std::vector<Vec3>& ahead,
                       double reach, int threads) {
  frames_.update(x, ahead, SHAPE_SHARE * base_margin_, threads);
  findClosePieces(reach);
  active_.clear();
  stale_.clear();
  incomplete_.clear();
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
    if ((*at)->is_searched && (*at)->search.holds(frames_.pieces()[a], frames_.pieces()[b])) {
      if ((*at)->is_incomplete) incomplete_.push_back(at->get());
      continue;
    }
    stale_.push_back(at->get());
    to_place_.insert(to_place_.end(), {a, b});
  }
  sortOnce(&to_place_);
  placed_.assign(pairs_.size(), false);
  placeTrees(surface, x, to_place_, threads);
  shares_.clear();
  for (std::size_t i = 0; i < stale_.size(); ++i) startSearch(reach, i);
  searchShares(surface, x, threads);
  addFresh(surface, x, threads);
  narrowAll(surface, x, ahead, threads);
  searches_ += static_cast<int>(stale_.size());
}

const PieceTrees& NearPairs::placeTrees(const ContactSurface& surface, const std::vector<Vec3>& x,
                                        const std::vector<int>& pieces, int threads) {
  if (!pieces.empty() && !has_trees_) {
    trees_.build(surface);
    has_trees_ = true;
  }
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

/// Divides the search of a pair, which may be the only one, into shares.
void NearPairs::startSearch(double reach, std::size_t stale) {
  Pair* const pair = stale_[stale];
  const PieceFrames::Piece &a = frames_.pieces()[pair->a], &b = frames_.pieces()[pair->b];
  pair->is_searched = pair->is_incomplete = pair->is_narrow = false;
  pair->near.clear();
  pair->edges.clear();
  pair->search.begin(a, b, pair->a == pair->b ? margin_of_one_ : base_margin_);
  pair->size = std::max(a.size, b.size);
  pair->reach = reach * pair->size;
  pair->searched = {TURNING * (pair->reach + pair->search.margin()), TURNING * pair->search.margin()};
  for (const PieceTrees::Share& nodes : trees_.shares(pair->a, pair->b, pair->searched.further, SHARES))
    shares_.push_back({stale, nodes, {}, {}});
}

/// What all find together is sorted, so it makes no difference how it was divided.
void NearPairs::searchShares(const ContactSurface& surface, const std::vector<Vec3>& x, int threads) {
  parallelFor(static_cast<int>(shares_.size()), threads, [&](int i) {
    Share& share = shares_[i];
    const Pair& pair = *stale_[share.stale];
    trees_.forEachClose(share.nodes, pair.searched.further, [&](int one, int other) {
      if (share.nodes.of_edges)
        share.edges.emplace_back(one, other);
      else if (mayMeet(surface, x, one, other, pair.searched, pair.a == pair.b))
        share.faces.push_back({one, other});
    });
  });
  for (const Share& share : shares_) {
    Pair* const pair = stale_[share.stale];
    pair->near.insert(pair->near.end(), share.faces.begin(), share.faces.end());
    pair->edges.insert(pair->edges.end(), share.edges.begin(), share.edges.end());
  }
  parallelFor(static_cast<int>(stale_.size()), threads, [&](int i) {
    stale_[i]->sort();
    stale_[i]->is_searched = true;
  });
}

/// What is fresh can come nearer by what is left of the margin, and by what goes back of what others have moved since
/// the search. Pairs that are not looked at in this step lack it until they are.
void NearPairs::addFresh(const ContactSurface& surface, const std::vector<Vec3>& x, int threads) {
  parallelFor(static_cast<int>(incomplete_.size()), threads, [&](int i) {
    Pair* const pair = incomplete_[i];
    pair->is_searched = pair->is_narrow = false;
    const PieceFrames::Piece &a = frames_.pieces()[pair->a], &b = frames_.pieces()[pair->b];
    const double more = TURNING * (pair->search.needed(a, b) - 2 * pair->search.usedUp(a, b));
    const Reach reach = {pair->searched.further + more, pair->searched.aside + more};
    fresh_.addFaces(surface, x, pair->a, pair->b, reach, &pair->near);
    if (pair->a != pair->b) {
      fresh_.addFaces(surface, x, pair->b, pair->a, reach, &pair->near);
      fresh_.addEdges(surface, x, pair->a, pair->b, reach.further, &pair->edges);
    }
    pair->sort();
    pair->is_searched = true;
    pair->is_incomplete = false;
  });
}

/// A piece by itself, as one that is being cut, has too little near for that to pay.
void NearPairs::narrowAll(const ContactSurface& surface, const std::vector<Vec3>& x, const std::vector<Vec3>& ahead,
                          int threads) {
  if (std::all_of(active_.begin(), active_.end(), [](const Pair* pair) { return pair->a == pair->b; })) {
    for (Pair* pair : active_) pair->is_narrow = false;
    return;
  }
  close_frames_.update(x, ahead, SHAPE_SHARE * narrow_margin_, threads);
  parallelFor(static_cast<int>(active_.size()), threads, [&](int i) { narrow(surface, x, active_[i]); });
}

/// Looks once more, and less far, through what is near. Where the two move so much that it would soon be out of date
/// there is none.
void NearPairs::narrow(const ContactSurface& surface, const std::vector<Vec3>& x, Pair* pair) const {
  const PieceFrames::Piece &a = close_frames_.pieces()[pair->a], &b = close_frames_.pieces()[pair->b];
  if (pair->is_narrow && pair->narrow.holds(a, b)) return;
  pair->narrow.begin(a, b, narrow_margin_);
  pair->is_narrow = false;
  if (pair->narrow.margin() > 2 * narrow_margin_) return;
  const double margin = TURNING * pair->narrow.margin();
  const Reach reach = {TURNING * pair->reach + margin, margin};
  pair->nearest.clear();
  for (const SampleTriangle& at : pair->near)
    if (mayMeet(surface, x, at.sample, at.triangle, reach, pair->a == pair->b)) pair->nearest.push_back(at);
  pair->is_narrow = true;
}

/// What was kept mostly is in order, with what was found at its end.
void NearPairs::Pair::sort() {
  const auto by_sample = [](const SampleTriangle& s, const SampleTriangle& t) {
    return std::tie(s.sample, s.triangle) < std::tie(t.sample, t.triangle);
  };
  const auto unordered = std::is_sorted_until(near.begin(), near.end(), by_sample);
  std::sort(unordered, near.end(), by_sample);
  std::inplace_merge(near.begin(), unordered, near.end(), by_sample);
  std::sort(edges.begin(), edges.end());
}

}  // namespace incision
