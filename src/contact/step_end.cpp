#include "incision/contact/step_end.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>

#include "incision/base/sort_once.h"
#include "incision/contact/edge_meeting.h"
#include "incision/contact/face_meeting.h"

namespace incision {
namespace {

/// What the contacts of a step may be deeper at its end than was reckoned, in elements. A part of a step has its share.
constexpr double DEEPER = 0.03;

/// How far behind the plane of its face the vertex of a candidate is [m].
double depthBehind(const ContactSurface& surface, const Candidate& candidate, const std::vector<Vec3>& x) {
  const auto& [i, j, k] = surface.surface->triangles[candidate.triangle];
  const Vec3 a = x[i], b = x[j], c = x[k];
  const Vec3 p = x[surface.samples[candidate.sample].vertex];
  return (b - a).cross(c - a).stableNormalized().dot(a - p);
}

/// How deep two edges that still cross are in each other [m]; below zero where they do not.
double depthOfEdges(const ContactSurface& surface, const Candidate& candidate, const std::vector<Vec3>& x) {
  const ContactSurface::Edge &e = surface.edges[candidate.sample], &f = surface.edges[candidate.other];
  const Vec3 a = x[e.from], b = x[f.from];
  const EdgeCrossing at = crossingOf(a, x[e.to] - a, b, x[f.to] - b);
  return at.isWithin(0) ? -at.apart * std::copysign(1.0, at.normal.dot(candidate.normal)) : -1;
}

}  // namespace

bool StepEnd::isAsReckoned(const ContactSurface& surface, const std::vector<Candidate>& candidates,
                           Span<const Vec3> moved, double share, const std::vector<Vec3>& x, NearPairs* pairs,
                           int threads) {
  suspects_.clear();
  pieces_.clear();
  for (int i = 0; i < moved.size(); ++i) {
    const Candidate& candidate = candidates[i];
    const double more = share * DEEPER * candidate.size;
    if (!candidate.isOfBody() || moved[i].squaredNorm() < more * more) continue;
    const double reckoned = -candidate.gap - candidate.normal.dot(moved[i]);
    const double allowed = more + std::max(reckoned, candidate.ignored);
    if (candidate.partner == Candidate::EDGES) {
      if (depthOfEdges(surface, candidate, x) > allowed) return false;
      continue;
    }
    const int piece = surface.piece[candidate.triangle];
    if (piece == surface.vertex_piece[surface.samples[candidate.sample].vertex]) continue;
    if (depthBehind(surface, candidate, x) <= allowed) continue;
    suspects_.emplace_back(i, allowed);
    pieces_.push_back(piece);
  }
  if (suspects_.empty()) return true;
  sortOnce(&pieces_);
  const PieceTrees& trees = pairs->placeTreesElsewhere(surface, x, pieces_, threads);
  return std::none_of(suspects_.begin(), suspects_.end(), [&](const auto& suspect) {
    const Candidate& candidate = candidates[suspect.first];
    const int vertex = surface.samples[candidate.sample].vertex;
    return insideOf(surface, x, vertex, trees, surface.piece[candidate.triangle]).depth > suspect.second;
  });
}

}  // namespace incision
