#include "incision/contact/face_meeting.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>

#include "incision/base/nearest.h"
#include "incision/contact/candidate.h"

namespace incision {
namespace {

/// Faces meet where their normals are against each other, by at least 72° from being at right angles… to 180°.
constexpr double MAX_COSINE = -0.3;

/// The foremost vertex of something thin meets a face with sides that are against it by more than this.
constexpr double LEAST_COSINE = -0.05;

/// By this sine what is round a vertex may be before it, and the vertex still be the foremost.
constexpr double FOREMOST = 0.02;

/// Distances that differ by this share of them are one, to a point of several triangles.
constexpr double SAME_DISTANCE = 1e-6;

/// Weights of the foot of p's perpendicular on a triangle, whose normal a has twice its area for length.
Vec3 footOf(const Vec3& p, const Vec3& p0, const Vec3& p1, const Vec3& p2, const Vec3& a) {
  const double square = a.squaredNorm();
  const double w1 = (p - p0).cross(p2 - p0).dot(a) / square, w2 = (p1 - p0).cross(p - p0).dot(a) / square;
  return {1 - w1 - w2, w1, w2};
}

/// Whether the surface round a vertex lies before it nowhere, as seen along n.
bool isForemost(const SkinInStep& skin, int vertex, const Vec3& n) {
  const ContactSurface& surface = skin.surface;
  const int first = surface.samples[surface.sample_start[vertex]].first;
  const int last = surface.samples[surface.sample_start[vertex + 1] - 1].last;
  for (int k = first; k < last; ++k)
    for (int v : surface.surface->triangles[surface.around[k]]) {
      const Vec3 to = skin.x[v] - skin.x[vertex];
      if (n.dot(to) < -FOREMOST * to.norm()) return false;
    }
  return true;
}

/// Whether a sample's side faces along −n, or none of its vertex does and it does so most of all, as where the point of
/// something thin meets a face.
bool faces(const SkinInStep& skin, int sample, const Vec3& n) {
  const double cosine = n.dot(skin.sample_normals[sample]);
  if (cosine < MAX_COSINE) return true;
  if (cosine >= LEAST_COSINE) return false;
  const int vertex = skin.surface.samples[sample].vertex;
  for (int s = skin.surface.sample_start[vertex]; s < skin.surface.sample_start[vertex + 1]; ++s) {
    const double other = n.dot(skin.sample_normals[s]);
    if (other < cosine || (other == cosine && s < sample)) return false;
  }
  return isForemost(skin, vertex, n);
}

/// The share of the step after which a gap that changes evenly is closed, or narrowest.
double closingTime(double start, double end) {
  if (start <= 0 || end >= start) return 0;
  return end <= 0 ? start / (start - end) : 1;
}

/// The foot of a sample on a triangle's plane after a share of the step.
FaceMeeting footAfter(const SkinInStep& skin, int sample, int triangle, double share) {
  const int vertex = skin.surface.samples[sample].vertex;
  const auto& [a, b, c] = skin.surface.surface->triangles[triangle];
  const Vec3 pa = skin.at(a, share), pb = skin.at(b, share), pc = skin.at(c, share);
  const Vec3 area = (pb - pa).cross(pc - pa);
  FaceMeeting met{sample, triangle, area.stableNormalized(), footOf(skin.at(vertex, share), pa, pb, pc, area), 0};
  const Vec3 foot = met.weights[0] * skin.x[a] + met.weights[1] * skin.x[b] + met.weights[2] * skin.x[c];
  met.gap = met.normal.dot(skin.x[vertex] - foot);
  return met;
}

}  // namespace

std::optional<FaceMeeting> meetFace(const SkinInStep& skin, int sample, int triangle) {
  const Vec3 &n = skin.normals[triangle], &m = skin.end_normals[triangle];
  if (!(n.dot(skin.sample_normals[sample]) < LEAST_COSINE)) return std::nullopt;
  const int vertex = skin.surface.samples[sample].vertex, corner = skin.surface.surface->triangles[triangle][0];
  const double size = skin.surface.size[vertex], gap = n.dot(skin.x[vertex] - skin.x[corner]);
  if (!(gap > -MAX_DEPTH * size)) return std::nullopt;
  const double end = m.dot(skin.at(vertex, 1) - skin.at(corner, 1));
  if (!(std::min(gap, end) < MARGIN * size)) return std::nullopt;
  const double share = closingTime(gap, end);
  FaceMeeting met = footAfter(skin, sample, triangle, share);
  // What turns so far that along the normal it would be deep from the start is taken as it is then.
  if (share > 0 && met.gap < 0) met = footAfter(skin, sample, triangle, 0);
  if (!(met.weights.minCoeff() > -RIM) || !faces(skin, sample, n)) return std::nullopt;
  return met;
}

Inside insideOf(const ContactSurface& surface, const std::vector<Vec3>& x, int vertex, const PieceTrees& trees,
                int piece) {
  double nearest = std::numeric_limits<double>::infinity(), facing = 0;
  Vec3 normal = Vec3::Zero();
  const Vec3& p = x[vertex];
  trees.forEachNear(piece, p, [&](int t) {
    if (!hasAreaAtRest(surface, t)) return (1 + SAME_DISTANCE) * nearest;
    const auto& [i, j, k] = surface.surface->triangles[t];
    const Vec3 &a = x[i], &b = x[j], &c = x[k], n = (b - a).cross(c - a).stableNormalized();
    const Vec3 near_p = nearestOnTriangle({a, b, c}, p);
    const double distance = (p - near_p).squaredNorm(), gap = n.dot(p - a);
    if (distance > (1 + SAME_DISTANCE) * nearest) return (1 + SAME_DISTANCE) * nearest;
    if (distance < (1 - SAME_DISTANCE) * nearest || std::abs(gap) > std::abs(facing)) {
      facing = gap;
      normal = n;
    }
    nearest = std::min(nearest, distance);
    return (1 + SAME_DISTANCE) * nearest;
  });
  return {facing < 0 ? std::sqrt(nearest) : 0, normal};
}

}  // namespace incision
