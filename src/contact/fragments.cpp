#include "incision/contact/fragments.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <tuple>

#include "incision/base/parallel.h"
#include "incision/base/sort_once.h"

namespace incision {
namespace {

/// How near, in elements, two things come that may meet: the depth that still is a contact, and what a triangle is
/// wider than it is.
constexpr double REACH = MAX_DEPTH + 0.05;

/// A foot with more than this weight on a corner is that corner: twins, as on two faces born together, are one contact.
constexpr double TWIN = 0.98;

/// Depths beyond this, in elements, are looked at twice: whether the point is inside, or was on that side before.
constexpr double SHALLOW = 2e-3;

/// A face that is so many times farther from a point inside than the nearest one is not where it has come in.
constexpr double FARTHER = 1.2;

/// Normals whose cosine is more are those of one side of something thin.
constexpr double SAME_SIDE = 0.5;

/// Where the cosine of the angle between the normals of two crossings is more, one may continue the other.
constexpr double SAME_CROSSING = 0.98;

/// Two edges that begin to touch deeper than this, in elements, do not touch: the pieces lie side by side.
constexpr double SHALLOW_EDGES = 0.01;

/// The area of a contact of edges, as a share of an element's face: what an edge gives way is spread as far as that.
constexpr double EDGE_AREA = 0.1;

/// A point and its foot that share all weights but this much move as one: so near the end of a slit, or where the
/// surface meets itself at an edge, the material keeps them together.
constexpr double ONE_POINT = 0.05;

/// Samples with triangles that a thread looks at one after the other: some 20 µs.
constexpr std::ptrdiff_t SHARE = 512;

bool isOnePoint(const Spring& contact) {
  double sum = 0;
  for (int i = 0; i < contact.count; ++i) sum += std::abs(contact.weights[i]);
  return sum < ONE_POINT;
}

/// What a contact acts on: the sample's point less its foot.
Spring between(const ContactSurface& surface, const FaceMeeting& met) {
  Spring contact;
  addVertex(surface.surface->vertices[surface.samples[met.sample].vertex], 1, &contact);
  for (int k = 0; k < 3; ++k)
    addVertex(surface.surface->vertices[surface.surface->triangles[met.triangle][k]], -met.weights[k], &contact);
  return contact;
}

Spring between(const ContactSurface& surface, const EdgeMeeting& met) {
  const ContactSurface::Edge &e = surface.edges[met.edge], &f = surface.edges[met.other];
  Spring contact;
  addVertex(surface.surface->vertices[e.from], 1 - met.share, &contact);
  addVertex(surface.surface->vertices[e.to], met.share, &contact);
  addVertex(surface.surface->vertices[f.from], met.there - 1, &contact);
  addVertex(surface.surface->vertices[f.to], -met.there, &contact);
  return contact;
}

/// Whether edges of the two pieces have crossed before as these do: these, or those that they continue.
bool haveCrossed(const ContactSurface& surface, const std::vector<Touch>& touches, const EdgeMeeting& met) {
  const auto piece = [&](int edge) { return surface.vertex_piece[surface.edges[edge].from]; };
  for (const Touch& touch : touches) {
    if (touch.partner != Candidate::EDGES) break;  // these come first
    const int one = piece(touch.sample), other = piece(touch.other);
    const double along = touch.normal_in_solid.dot(met.normal);
    if (one == piece(met.edge) && other == piece(met.other) && along > SAME_CROSSING) return true;
    if (one == piece(met.other) && other == piece(met.edge) && along < -SAME_CROSSING) return true;
  }
  return false;
}

/// Whether a point that is deep behind a face has come in there. Where it was on that side before, it may even have
/// come out on the far side of something thin.
bool hasComeIn(const Inside& inside, const FaceMeeting& met, bool side_known) {
  if (side_known) return inside.depth > 0 || inside.normal.dot(met.normal) < -SAME_SIDE;
  return -met.gap <= FARTHER * inside.depth;
}

Candidate makeCandidate(int partner, const Vec3& normal, double gap, const Spring& point) {
  Candidate made;
  made.partner = partner;
  made.normal = made.normal_in_solid = normal;
  made.gap = gap;
  made.drift.setZero();
  made.slip.setZero();
  made.point = point;
  return made;
}

Candidate candidateOf(const ContactSurface& surface, const FaceMeeting& met, double share) {
  const ContactSurface::Sample& sample = surface.samples[met.sample];
  Candidate made = makeCandidate(Candidate::BODY, met.normal, met.gap, between(surface, met));
  made.sample = met.sample;
  int corner = 0;
  met.weights.maxCoeff(&corner);
  made.other = surface.surface->triangles[met.triangle][corner];
  made.triangle = met.triangle;
  made.size = surface.size[sample.vertex];
  made.stiffness = share * (CONTACT_STIFFNESS * surface.young_modulus[sample.vertex]) * sample.area / made.size;
  return made;
}

/// How far from an end of one of them two edges cross: round it they come apart without moving along the normal.
double distanceFromEnds(const SkinInStep& skin, const EdgeMeeting& met) {
  const auto from_end = [&](int edge, double share) {
    const ContactSurface::Edge& e = skin.surface.edges[edge];
    return std::min(share, 1 - share) * (skin.x[e.to] - skin.x[e.from]).norm();
  };
  return std::min(from_end(met.edge, met.share), from_end(met.other, met.there));
}

Candidate candidateOf(const SkinInStep& skin, const EdgeMeeting& met) {
  const ContactSurface& surface = skin.surface;
  const int e = surface.edges[met.edge].from, f = surface.edges[met.other].from;
  Candidate made = makeCandidate(Candidate::EDGES, met.normal, met.gap, between(surface, met));
  made.sample = met.edge;
  made.other = met.other;
  made.goes_on = met.goes_on;
  made.way_out = distanceFromEnds(skin, met);
  made.size = std::min(surface.size[e], surface.size[f]);
  made.stiffness =
      CONTACT_STIFFNESS * std::min(surface.young_modulus[e], surface.young_modulus[f]) * EDGE_AREA * made.size;
  return made;
}

/// Where a sample meets a piece: the nearest place, or whether it is so deep that it must be looked at twice.
struct Nearest {
  std::optional<FaceMeeting> met;
  bool is_deep = false;
};

/// The nearest place where a sample meets one of the triangles near it. What is deep must be inside, as the `trees`
/// tell where there are any, or have been on that side; that is preferred then.
Nearest nearestFace(const SkinInStep& skin, const std::vector<Touch>& touches, Span<const SampleTriangle> near,
                    bool of_one_piece, const PieceTrees* trees) {
  const ContactSurface& surface = skin.surface;
  const int sample = near[0].sample, vertex = surface.samples[sample].vertex;
  std::optional<Inside> inside;
  std::optional<FaceMeeting> best;
  bool best_known = false;
  for (const SampleTriangle& at : near) {
    const std::optional<FaceMeeting> met = meetFace(skin, sample, at.triangle);
    if (!met || (of_one_piece && isOnePoint(between(surface, *met)))) continue;
    bool side_known = false;
    if (met->gap < -SHALLOW * surface.size[vertex] && !of_one_piece) {
      if (!trees) return {std::nullopt, true};
      const int corner = surface.surface->triangles[met->triangle][0];
      const Touch* touch = touchBefore(surface, touches, Candidate::BODY, sample, corner);
      side_known = touch && touch->normal_in_solid.dot(met->normal) > SAME_SIDE;
      if (!inside) inside = insideOf(surface, skin.x, vertex, *trees, surface.piece[met->triangle]);
      if (!hasComeIn(*inside, *met, side_known)) continue;
    }
    const bool nearer = !best || std::abs(met->gap) < std::abs(best->gap);
    if (side_known == best_known ? !nearer : best_known) continue;
    best = met;
    best_known = side_known;
  }
  return {best, false};
}

}  // namespace

void FragmentFinder::find(const ContactSurface& surface, const std::vector<Vec3>& x, const std::vector<Vec3>& ahead,
                          const std::vector<Touch>& touches, int threads, std::vector<Candidate>* candidates) {
  if (changed_) pairs_.surfaceChanged(surface, x);
  changed_ = false;
  pairs_.update(surface, x, ahead, REACH, threads);
  measure(surface, x, ahead, threads);
  const SkinInStep skin{surface, x, ahead, normals_, end_normals_, sample_normals_};
  const std::vector<NearPairs::Pair*>& pairs = pairs_.active();
  divideFaces();
  parallelFor(shares_used_, threads, [&](int i) { findFaces(skin, touches, &shares_[i]); });
  if (edges_in_.size() < pairs.size()) edges_in_.resize(pairs.size());
  parallelFor(static_cast<int>(pairs.size()), threads,
              [&](int i) { findEdges(skin, touches, *pairs[i], &edges_in_[i]); });
  findDeepFaces(skin, touches, threads);
  gather();
  for (const EdgeMeeting& met : edges_) candidates->push_back(candidateOf(skin, met));
  for (const Found& met : faces_) {
    const int twin = twinOf(surface, met);
    if (twin < 0 || twin > met.sample) candidates->push_back(candidateOf(surface, met, twin < 0 ? 0.5 : 1));
  }
}

void FragmentFinder::measure(const ContactSurface& surface, const std::vector<Vec3>& x, const std::vector<Vec3>& ahead,
                             int threads) {
  const auto& triangles = surface.surface->triangles;
  normals_.resize(triangles.size());
  end_normals_.resize(triangles.size());
  parallelFor(static_cast<int>(triangles.size()), threads, [&](int t) {
    const auto& [a, b, c] = triangles[t];
    const Vec3 u = x[b] - x[a], v = x[c] - x[a];
    normals_[t] = u.cross(v);
    end_normals_[t] = (u + (ahead[b] - ahead[a])).cross(v + (ahead[c] - ahead[a])).stableNormalized();
  });
  sample_normals_.resize(surface.samples.size());
  parallelFor(static_cast<int>(sample_normals_.size()), threads, [&](int s) {
    Vec3 sum = Vec3::Zero();
    for (int k = surface.samples[s].first; k < surface.samples[s].last; ++k) sum += normals_[surface.around[k]];
    sample_normals_[s] = sum.stableNormalized();
  });
  parallelFor(static_cast<int>(triangles.size()), threads, [&](int t) { normals_[t].stableNormalize(); });
}

/// Divides the faces of each pair, which may be the only one.
void FragmentFinder::divideFaces() {
  shares_used_ = 0;
  for (const NearPairs::Pair* pair : pairs_.active()) {
    const SampleTriangle *first = pair->faces().data(), *const end = first + pair->faces().size();
    for (const auto* last = first; first != end; first = last) {
      last = end - first > SHARE ? first + SHARE : end;
      while (last != end && last->sample == last[-1].sample) ++last;
      if (shares_used_ == static_cast<int>(shares_.size())) shares_.emplace_back();
      Share& share = shares_[shares_used_++];
      share.first = first;
      share.last = last;
      share.of_one_piece = pair->a == pair->b;
    }
  }
}

/// The nearest places where samples meet the other piece.
void FragmentFinder::findFaces(const SkinInStep& skin, const std::vector<Touch>& touches, Share* share) const {
  share->found.clear();
  share->deep.clear();
  const SampleTriangle* first = share->first;
  for (const auto* last = first; first != share->last; first = last) {
    while (last != share->last && last->sample == first->sample) ++last;
    const Nearest nearest = nearestFace(skin, touches, {first, last}, share->of_one_piece, nullptr);
    if (nearest.met) share->found.push_back({*nearest.met, skin.surface.piece[nearest.met->triangle]});
    if (nearest.is_deep) share->deep.emplace_back(first, last);
  }
}

/// Those of samples that are deep, once the trees of the pieces are where these are.
void FragmentFinder::findDeepFaces(const SkinInStep& skin, const std::vector<Touch>& touches, int threads) {
  deep_in_.clear();
  for (int i = 0; i < shares_used_; ++i)
    for (const Span<const SampleTriangle>& near : shares_[i].deep)
      deep_in_.push_back(skin.surface.piece[near[0].triangle]);
  sortOnce(&deep_in_);
  const PieceTrees& trees = pairs_.placeTrees(skin.surface, skin.x, deep_in_, threads);
  parallelFor(shares_used_, threads, [&](int i) {
    for (const Span<const SampleTriangle>& near : shares_[i].deep)
      if (const Nearest nearest = nearestFace(skin, touches, near, false, &trees); nearest.met)
        shares_[i].found.push_back({*nearest.met, skin.surface.piece[nearest.met->triangle]});
  });
}

void FragmentFinder::findEdges(const SkinInStep& skin, const std::vector<Touch>& touches, const NearPairs::Pair& pair,
                               std::vector<EdgeMeeting>* found) const {
  found->clear();
  for (const auto& [a, b] : pair.edges) {
    std::optional<EdgeMeeting> met = meetEdges(skin, std::min(a, b), std::max(a, b));
    if (!met) continue;
    const double size = skin.surface.size[skin.surface.edges[a].from];
    if (met->gap < -SHALLOW_EDGES * size) {
      met->goes_on = haveCrossed(skin.surface, touches, *met);
      if (!met->goes_on) continue;
    }
    found->push_back(*met);
  }
}

void FragmentFinder::gather() {
  faces_.clear();
  for (int i = 0; i < shares_used_; ++i) faces_.insert(faces_.end(), shares_[i].found.begin(), shares_[i].found.end());
  edges_.clear();
  for (std::size_t i = 0; i < pairs_.active().size(); ++i)
    edges_.insert(edges_.end(), edges_in_[i].begin(), edges_in_[i].end());
  std::sort(faces_.begin(), faces_.end(),
            [](const Found& a, const Found& b) { return std::tie(a.sample, a.piece) < std::tie(b.sample, b.piece); });
  std::sort(edges_.begin(), edges_.end(), [](const EdgeMeeting& a, const EdgeMeeting& b) {
    return std::tie(a.edge, a.other) < std::tie(b.edge, b.other);
  });
}

/// The sample that has this one for its foot as this one has it, or −1.
int FragmentFinder::twinOf(const ContactSurface& surface, const Found& found) const {
  const auto cornerOver = [&](const FaceMeeting& over, int vertex) {
    for (int k = 0; k < 3; ++k)
      if (over.weights[k] > TWIN && (vertex < 0 || surface.surface->triangles[over.triangle][k] == vertex))
        return surface.surface->triangles[over.triangle][k];
    return -1;
  };
  const int foot = cornerOver(found, -1), vertex = surface.samples[found.sample].vertex;
  if (foot < 0) return -1;
  auto at = std::lower_bound(faces_.begin(), faces_.end(), surface.sample_start[foot],
                             [](const Found& a, int sample) { return a.sample < sample; });
  for (; at != faces_.end() && at->sample < surface.sample_start[foot + 1]; ++at)
    if (at->piece == surface.vertex_piece[vertex] && cornerOver(*at, vertex) >= 0) return at->sample;
  return -1;
}

}  // namespace incision
