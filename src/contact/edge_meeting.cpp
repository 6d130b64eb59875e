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

/// So near to an end of an edge, as a share of it, a vertex is what meets the other.
constexpr double AT_END = 1e-3;

/// Whether the faces beside an edge lie behind the plane through it with normal n.
bool liesBehind(const SkinInStep& skin, const SkinEdge& edge, const Vec3& n) {
  const Vec3 from = skin.x[edge.from];
  for (int v : edge.opposite) {
    const Vec3 to = skin.x[v] - from;
    if (n.dot(to) > WEDGE * to.norm()) return false;
  }
  return true;
}

}  // namespace

std::optional<EdgeMeeting> meetEdges(const SkinInStep& skin, int edge, int other) {
  const SkinEdge &e = skin.surface.edges[edge], &f = skin.surface.edges[other];
  const Vec3 a = skin.x[e.from], b = skin.x[f.from], d = a - b;
  const Vec3 u = skin.x[e.to] - a, v = skin.x[f.to] - b, across = u.cross(v);
  const double uu = u.squaredNorm(), vv = v.squaredNorm(), uv = u.dot(v), square = across.squaredNorm();
  if (!(square > PARALLEL * PARALLEL * uu * vv)) return std::nullopt;
  const double s = (uv * v.dot(d) - vv * u.dot(d)) / square, t = (uu * v.dot(d) - uv * u.dot(d)) / square;
  if (!(std::min(s, t) > AT_END && std::max(s, t) < 1 - AT_END)) return std::nullopt;
  Vec3 n = across / std::sqrt(square);
  if (!liesBehind(skin, f, n)) n = -n;
  if (!liesBehind(skin, f, n) || !liesBehind(skin, e, -n)) return std::nullopt;
  const auto apart = [&](const std::vector<Vec3>& values) -> Vec3 {
    return (1 - s) * values[e.from] + s * values[e.to] - (1 - t) * values[f.from] - t * values[f.to];
  };
  const double size = std::min(skin.surface.size[e.from], skin.surface.size[f.from]);
  const double gap = n.dot(apart(skin.x)), closing = n.dot(apart(skin.ahead));
  if (!(gap > -MAX_DEPTH * size && gap + std::min(0.0, closing) < MARGIN * size)) return std::nullopt;
  return EdgeMeeting{edge, other, n, s, t, gap};
}

}  // namespace incision
