#include "incision/surface/vertex_fields.h"

#include <Eigen/Geometry>
#include <algorithm>

namespace incision {
Vec3 vectorArea(const std::array<int, 3>& triangle, const std::vector<Vec3>& x) {
  const Vec3& a = x[triangle[0]];
  return 0.5 * (x[triangle[1]] - a).cross(x[triangle[2]] - a);
}

std::vector<Vec3> vertexNormals(const Surface& surface, const std::vector<Vec3>& x) {
  std::vector<Vec3> normals(x.size(), Vec3::Zero());
  for (const auto& triangle : surface.triangles)
    for (int v : triangle) normals[v] += vectorArea(triangle, x);
  for (Vec3& normal : normals) normal.stableNormalize();
  return normals;
}

std::vector<double> vertexMeans(const Surface& surface, const std::vector<Vec3>& x,
                                const std::vector<double>& of_triangle) {
  struct Sums {
    double weighted = 0, area = 0, plain = 0;
    int count = 0;
  };
  std::vector<Sums> sums(x.size());
  for (std::size_t t = 0; t < surface.triangles.size(); ++t) {
    const double area = vectorArea(surface.triangles[t], x).norm();
    for (int v : surface.triangles[t]) {
      sums[v].weighted += area * of_triangle[t];
      sums[v].area += area;
      sums[v].plain += of_triangle[t];
      ++sums[v].count;
    }
  }
  std::vector<double> means;
  for (const Sums& sum : sums)
    means.push_back(sum.area > 0 ? sum.weighted / sum.area : sum.plain / std::max(1, sum.count));
  return means;
}

}  // namespace incision
