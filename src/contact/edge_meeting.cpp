#include "incision/contact/edge_meeting.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>

#include "incision/contact/candidate.h"

namespace incision {
namespace {

using Edge = ContactSurface::Edge;

/// Sine of the angle between two edges below which they run along each other: their ends then meet faces.
constexpr double PARALLEL = 0.02;

/// By this sine a face beside an edge may be on the wrong side of the plane through both.
constexpr double WEDGE = 0.01;

/// So near to an end of an edge, as a share of it, a vertex is what meets the other.
constexpr double AT_END = 1e-3;

/// Twice the distance of the two lines, signed, with their angle's sine and lengths in it: (b × a)·(from one to other).
double signedVolume(const SkinInStep& skin, const Edge& e, const Edge& f, double share) {
  const Vec3 a = skin.at(e.from, share), b = skin.at(f.from, share);
  return (skin.at(e.to, share) - a).cross(skin.at(f.to, share) - b).dot(a - b);
}

/// The share of the step after which the two lines meet, or are nearest to that.
double meetingTime(double start, double end) {
  if (start * end < 0) return start / (start - end);
  return std::abs(end) < std::abs(start) ? 1 : 0;
}

/// Whether the faces beside an edge lie behind the plane through it with normal n.
bool liesBehind(const SkinInStep& skin, const Edge& edge, const Vec3& n, double share) {
  const Vec3 from = skin.at(edge.from, share);
  for (int v : edge.opposite) {
    const Vec3 to = skin.at(v, share) - from;
    if (n.dot(to) > WEDGE * to.norm()) return false;
  }
  return true;
}

/// How they meet if it is after this share of the step.
std::optional<EdgeMeeting> meetAfter(const SkinInStep& skin, int edge, int other, double share) {
  const Edge &e = skin.surface.edges[edge], &f = skin.surface.edges[other];
  const Vec3 a = skin.at(e.from, share), b = skin.at(f.from, share), d = a - b;
  const Vec3 u = skin.at(e.to, share) - a, v = skin.at(f.to, share) - b, across = u.cross(v);
  const double uu = u.squaredNorm(), vv = v.squaredNorm(), uv = u.dot(v), square = across.squaredNorm();
  if (!(square > PARALLEL * PARALLEL * uu * vv)) return std::nullopt;
  const double s = (uv * v.dot(d) - vv * u.dot(d)) / square, t = (uu * v.dot(d) - uv * u.dot(d)) / square;
  if (!(std::min(s, t) > AT_END && std::max(s, t) < 1 - AT_END)) return std::nullopt;
  Vec3 n = across / std::sqrt(square);
  if (!liesBehind(skin, f, n, share)) n = -n;
  if (!liesBehind(skin, f, n, share) || !liesBehind(skin, e, -n, share)) return std::nullopt;
  const auto apart = [&](const std::vector<Vec3>& values) -> Vec3 {
    return (1 - s) * values[e.from] + s * values[e.to] - (1 - t) * values[f.from] - t * values[f.to];
  };
  const double size = std::min(skin.surface.size[e.from], skin.surface.size[f.from]);
  const double gap = n.dot(apart(skin.x)), closing = n.dot(apart(skin.ahead));
  if (!(gap > -MAX_DEPTH * size && gap + std::min(0.0, closing) < MARGIN * size)) return std::nullopt;
  return EdgeMeeting{edge, other, n, s, t, gap};
}

}  // namespace

std::optional<EdgeMeeting> meetEdges(const SkinInStep& skin, int edge, int other) {
  const Edge &e = skin.surface.edges[edge], &f = skin.surface.edges[other];
  const double share = meetingTime(signedVolume(skin, e, f, 0), signedVolume(skin, e, f, 1));
  const std::optional<EdgeMeeting> met = meetAfter(skin, edge, other, share);
  // What turns so far that along the normal it would be deep from the start is taken as it is then.
  return share > 0 && met && met->gap < 0 ? meetAfter(skin, edge, other, 0) : met;
}

}  // namespace incision
