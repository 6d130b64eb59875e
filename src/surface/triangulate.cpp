#include "incision/surface/triangulate.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <limits>

namespace incision {
namespace {

/// Area against the squares of the edges: 0 when flat, largest when equilateral.
double quality(const Vec3& a, const Vec3& b, const Vec3& c) {
  const double squares = (b - a).squaredNorm() + (c - b).squaredNorm() + (a - c).squaredNorm();
  return squares > 0 ? (b - a).cross(c - a).norm() / squares : 0;
}

/// best(i, j): the worst triangle of the best triangulation of the polygon i, i + 1 … j, which
/// is max over k of min{best(i, k), best(k, j), quality(i, k, j)}; apex(i, j) is that k.
class BestTriangulation {
 public:
  explicit BestTriangulation(const std::vector<Vec3>& loop)
      : n_(static_cast<int>(loop.size())), best_(n_ * n_, std::numeric_limits<double>::max()), apex_(n_ * n_, -1) {
    for (int span = 2; span < n_; ++span)
      for (int i = 0, j = span; j < n_; ++i, ++j) {
        best_[at(i, j)] = -1;
        for (int k = i + 1; k < j; ++k) {
          const double worst = std::min({best_[at(i, k)], best_[at(k, j)], quality(loop[i], loop[k], loop[j])});
          if (worst <= best_[at(i, j)]) continue;
          best_[at(i, j)] = worst;
          apex_[at(i, j)] = k;
        }
      }
  }

  void append(int i, int j, std::vector<std::array<int, 3>>* triangles) const {
    if (j - i < 2) return;
    const int k = apex_[at(i, j)];
    triangles->push_back({i, k, j});
    append(i, k, triangles);
    append(k, j, triangles);
  }

 private:
  int at(int i, int j) const { return i * n_ + j; }

  int n_;
  std::vector<double> best_;
  std::vector<int> apex_;
};

}  // namespace

std::vector<std::array<int, 3>> triangulate(const std::vector<Vec3>& loop) {
  if (loop.size() == 3) return {{0, 1, 2}};
  std::vector<std::array<int, 3>> triangles;
  BestTriangulation(loop).append(0, static_cast<int>(loop.size()) - 1, &triangles);
  return triangles;
}

}  // namespace incision
