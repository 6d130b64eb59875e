#include "incision/contact/edge_meeting.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>

#include "incision/contact/candidate.h"

namespace incision {
namespace {

using SkinEdge = ContactSurface::Edge;

/// Sine of the angle between two edges below which they run along each other: their ends then meet faces.
constexpr double PARALLEL = 0.02;

/// By this sine a face beside an edge may be on the wrong side of the plane through both.
constexpr double WEDGE = 0.01;

/// Two edges are looked at where they meet in the step if what they meet across turns little in it: the cosine is more.
/// Pieces that turn fast would be given energy by that.
constexpr double SAME_WAY = 0.98;

/// So near to an end of an edge, as a share of it, a vertex is what meets the other.
constexpr double AT_END = 1e-3;

/// Whether the faces beside an edge lie behind the plane through it with normal n after a share of the step.
bool liesBehind(const SkinInStep& skin, const SkinEdge& edge, const Vec3& n, double share) {
  const Vec3 from = skin.at(edge.from, share);
  for (int v : edge.opposite) {
    const Vec3 to = skin.at(v, share) - from;
    if (n.dot(to) > WEDGE * to.norm()) return false;
  }
  return true;
}

/// As the edges are after a share of the step. Of parallel ones nothing else is told.
EdgeCrossing crossingAfter(const SkinInStep& skin, const SkinEdge& e, const SkinEdge& f, double share) {
  const Vec3 a = skin.at(e.from, share), b = skin.at(f.from, share);
  const EdgeCrossing at = crossingOf(a, skin.at(e.to, share) - a, b, skin.at(f.to, share) - b);
  return at.parallel ? EdgeCrossing{0, 0, Vec3::Zero(), 0, true} : at;
}

/// The share of the step after which lines that are so far apart when it starts and ends cross, or are nearest.
double crossingTime(double start, double end) {
  if ((start < 0) != (end < 0)) return start / (start - end);
  return std::abs(end) < std::abs(start) ? 1 : 0;
}

/// As the edges are after a share of the step; the faces beside each must lie behind the other.
std::optional<EdgeMeeting> meetAfter(const SkinInStep& skin, int edge, int other, double share) {
  const SkinEdge &e = skin.surface.edges[edge], &f = skin.surface.edges[other];
  const EdgeCrossing at = crossingAfter(skin, e, f, share);
  if (!at.isWithin(AT_END)) return std::nullopt;
  Vec3 n = at.normal;
  if (!liesBehind(skin, f, n, share)) n = -n;
  if (!liesBehind(skin, f, n, share) || !liesBehind(skin, e, -n, share)) return std::nullopt;
  const auto apart = [&](const std::vector<Vec3>& values) -> Vec3 {
    return (1 - at.s) * values[e.from] + at.s * values[e.to] - (1 - at.t) * values[f.from] - at.t * values[f.to];
  };
  const double size = std::min(skin.surface.size[e.from], skin.surface.size[f.from]);
  const double gap = n.dot(apart(skin.x)), closing = n.dot(apart(skin.ahead));
  if (!(gap > -MAX_DEPTH * size && gap + std::min(0.0, closing) < MARGIN * size)) return std::nullopt;
  return EdgeMeeting{edge, other, n, at.s, at.t, gap};
}

}  // namespace

EdgeCrossing crossingOf(const Vec3& a, const Vec3& u, const Vec3& b, const Vec3& v) {
  const Vec3 d = a - b, across = u.cross(v);
  const double uu = u.squaredNorm(), vv = v.squaredNorm(), uv = u.dot(v), square = across.squaredNorm();
  if (!(square > 0)) return {0, 0, Vec3::Zero(), 0, true};
  const Vec3 n = across / std::sqrt(square);
  return {(uv * v.dot(d) - vv * u.dot(d)) / square, (uu * v.dot(d) - uv * u.dot(d)) / square, n, n.dot(d),
          square <= PARALLEL * PARALLEL * uu * vv};
}

std::optional<EdgeMeeting> meetEdges(const SkinInStep& skin, int edge, int other) {
  const SkinEdge &e = skin.surface.edges[edge], &f = skin.surface.edges[other];
  const EdgeCrossing start = crossingAfter(skin, e, f, 0), end = crossingAfter(skin, e, f, 1);
  const double far = MARGIN * std::min(skin.surface.size[e.from], skin.surface.size[f.from]);
  if (std::min(start.apart, end.apart) > far || std::max(start.apart, end.apart) < -far) return std::nullopt;
  const double share = start.parallel ? 1 : end.parallel ? 0 : crossingTime(start.apart, end.apart);
  if (share > 0 && start.normal.dot(end.normal) > SAME_WAY)
    if (const std::optional<EdgeMeeting> met = meetAfter(skin, edge, other, share); met && met->gap >= 0) return met;
  return meetAfter(skin, edge, other, 0);
}

}  // namespace incision
