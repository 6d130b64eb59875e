#include "geometry.h"

#include <Eigen/Geometry>
#include <Eigen/LU>
#include <cmath>
#include <limits>
#include <set>

#include "support/random.h"

namespace incision::report {
namespace {

bool meetsBox(const GridSettings& box, const PlaneCut& plane) {
  const Vec3 half = box.size / 2, middle = box.origin + half;
  return std::abs(plane.normal.dot(plane.point - middle)) < plane.normal.cwiseAbs().dot(half);
}

bool lineMeetsBox(const GridSettings& box, const PlaneCut& a, const PlaneCut& b) {
  const Vec3 along = a.normal.cross(b.normal);
  Mat3 rows;
  rows << a.normal.transpose(), b.normal.transpose(), along.transpose();
  const Vec3 on = rows.inverse() * Vec3(a.normal.dot(a.point), b.normal.dot(b.point), 0);
  double from = -std::numeric_limits<double>::infinity(), to = -from;
  for (int d = 0; d < 3; ++d) {
    const double s = (box.origin[d] - on[d]) / along[d], t = (box.origin[d] + box.size[d] - on[d]) / along[d];
    from = std::max(from, std::min(s, t));
    to = std::min(to, std::max(s, t));
  }
  return from < to;
}

bool pointInBox(const GridSettings& box, const PlaneCut& a, const PlaneCut& b, const PlaneCut& c) {
  Mat3 rows;
  rows << a.normal.transpose(), b.normal.transpose(), c.normal.transpose();
  const Vec3 at = rows.inverse() * Vec3(a.normal.dot(a.point), b.normal.dot(b.point), c.normal.dot(c.point));
  const Vec3 share = (at - box.origin).cwiseQuotient(box.size);
  return share.minCoeff() > 0 && share.maxCoeff() < 1;
}

}  // namespace

int zonesOfPlanes(const GridSettings& box, const std::vector<PlaneCut>& planes) {
  int zones = 1;
  for (std::size_t i = 0; i < planes.size(); ++i) {
    zones += meetsBox(box, planes[i]);
    for (std::size_t j = 0; j < i; ++j) {
      zones += lineMeetsBox(box, planes[i], planes[j]);
      for (std::size_t k = 0; k < j; ++k) zones += pointInBox(box, planes[i], planes[j], planes[k]);
    }
  }
  return zones;
}

int zonesBySampling(const GridSettings& box, const std::vector<PlaneCut>& planes, int points) {
  test::Random random(90);
  std::set<std::vector<bool>> zones;
  std::vector<bool> sides(planes.size());
  for (int k = 0; k < points; ++k) {
    const Vec3 at = box.origin + box.size.cwiseProduct(Vec3::Constant(0.5) + random.vector(0.5));
    for (std::size_t i = 0; i < planes.size(); ++i) sides[i] = planes[i].normal.dot(at - planes[i].point) > 0;
    zones.insert(sides);
  }
  return static_cast<int>(zones.size());
}

}  // namespace incision::report
