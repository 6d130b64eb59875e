#include "incision/cut/face_polygon.h"

#include "incision/mesh/tet_mesh.h"

namespace incision {
namespace {

/// Twice the signed area of a triangle, as a share of the face.
double orientation(const FacePoint& a, const FacePoint& b, const FacePoint& c) {
  return (b[1] - a[1]) * (c[2] - a[2]) - (b[2] - a[2]) * (c[1] - a[1]);
}

}  // namespace

std::vector<Barycentric> inElement(const FacePolygon& polygon, int face) {
  std::vector<Barycentric> points(polygon.size(), Barycentric::Zero());
  for (std::size_t k = 0; k < polygon.size(); ++k)
    for (int i = 0; i < 3; ++i) points[k][FACE_NODES[face][i]] = polygon[k][i];
  return points;
}

double faceShare(const FacePolygon& polygon) {
  double share = 0;
  for (std::size_t i = 2; i < polygon.size(); ++i) share += orientation(polygon[0], polygon[i - 1], polygon[i]);
  return share;
}

FacePoint centroid(const FacePolygon& polygon) {
  FacePoint weighted = FacePoint::Zero(), mean = FacePoint::Zero();
  double share = 0;
  for (std::size_t i = 2; i < polygon.size(); ++i) {
    const double a = orientation(polygon[0], polygon[i - 1], polygon[i]);
    weighted += a * (polygon[0] + polygon[i - 1] + polygon[i]) / 3;
    share += a;
  }
  if (share > 0) return weighted / share;
  for (const FacePoint& point : polygon) mean += point;
  return mean / static_cast<double>(polygon.size());
}

FacePolygon overlap(const FacePolygon& a, const FacePolygon& b) {
  FacePolygon kept, next;
  for (FacePolygon* polygon : {&kept, &next}) polygon->reserve(a.size() + b.size());
  kept = a;
  for (std::size_t i = 0; i < b.size() && !kept.empty(); ++i) {
    const FacePoint &p = b[i], &q = b[(i + 1) % b.size()];
    next.clear();
    for (std::size_t j = 0; j < kept.size(); ++j) {
      const FacePoint &u = kept[j], &v = kept[(j + 1) % kept.size()];
      const double du = orientation(p, q, u), dv = orientation(p, q, v);
      if (du >= 0) next.push_back(u);
      if ((du > 0 && dv < 0) || (du < 0 && dv > 0)) next.push_back(u + du / (du - dv) * (v - u));
    }
    kept.swap(next);
  }
  return kept;
}

}  // namespace incision
