#include "incision/surface/triangulate.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <limits>
#include <numeric>

namespace incision {
namespace {

using Triangles = std::vector<std::array<int, 3>>;

/// Area against the squares of the edges: 0 when flat, largest when equilateral.
double quality(const Vec3& a, const Vec3& b, const Vec3& c) {
  const double squares = (b - a).squaredNorm() + (c - b).squaredNorm() + (a - c).squaredNorm();
  return squares > 0 ? (b - a).cross(c - a).norm() / squares : 0;
}

/// best(i, j): the worst triangle of the best triangulation of the polygon of corners[i] … corners[j], which is
/// max over k of min{best(i, k), best(k, j), quality(i, k, j)}; apex(i, j) is that k.
class BestTriangulation {
 public:
  BestTriangulation(const std::vector<Vec3>& loop, const std::vector<int>& corners)
      : corners_(corners),
        n_(static_cast<int>(corners.size())),
        best_(n_ * n_, std::numeric_limits<double>::max()),
        apex_(n_ * n_, -1) {
    for (int span = 2; span < n_; ++span)
      for (int i = 0, j = span; j < n_; ++i, ++j) {
        best_[at(i, j)] = -1;
        for (int k = i + 1; k < j; ++k) {
          const double between = quality(loop[corners[i]], loop[corners[k]], loop[corners[j]]);
          const double worst = std::min({best_[at(i, k)], best_[at(k, j)], between});
          if (worst <= best_[at(i, j)]) continue;
          best_[at(i, j)] = worst;
          apex_[at(i, j)] = k;
        }
      }
  }

  void append(Triangles* triangles) const { append(0, n_ - 1, triangles); }

 private:
  void append(int i, int j, Triangles* triangles) const {
    if (j - i < 2) return;
    const int k = apex_[at(i, j)];
    triangles->push_back({corners_[i], corners_[k], corners_[j]});
    append(i, k, triangles);
    append(k, j, triangles);
  }

  int at(int i, int j) const { return i * n_ + j; }

  const std::vector<int>& corners_;
  int n_;
  std::vector<double> best_;
  std::vector<int> apex_;
};

/// The i for which the chord from corner i to corner i + n/2 leaves most area on its smaller side.
int bestHalving(const std::vector<Vec3>& loop, const std::vector<int>& corners) {
  const std::size_t n = corners.size(), half = n / 2;
  const auto corner = [&](std::size_t i) -> Vec3 { return loop[corners[i % n]] - loop[corners[0]]; };
  std::vector<Vec3> swept(n + 1, Vec3::Zero());  // Σ_{k<i} X_k × X_{k+1}
  for (std::size_t i = 0; i < n; ++i) swept[i + 1] = swept[i] + corner(i).cross(corner(i + 1));
  const Vec3& whole = swept[n];
  std::size_t best = 0;
  double most = -1;
  for (std::size_t i = 0; i + half < n; ++i) {
    const Vec3 cut_off = swept[i + half] - swept[i] + corner(i + half).cross(corner(i));
    const double smaller = std::min(cut_off.dot(whole), (whole - cut_off).dot(whole));
    if (smaller <= most) continue;
    most = smaller;
    best = i;
  }
  return static_cast<int>(best);
}

void triangulate(const std::vector<Vec3>& loop, const std::vector<int>& corners, Triangles* triangles) {
  const int n = static_cast<int>(corners.size());
  if (n <= MAX_BEST_CORNERS) {
    BestTriangulation(loop, corners).append(triangles);
    return;
  }
  const int i = bestHalving(loop, corners), j = i + n / 2;
  std::vector<int> half(corners.begin() + i, corners.begin() + j + 1);
  triangulate(loop, half, triangles);
  half.assign(corners.begin() + j, corners.end());
  half.insert(half.end(), corners.begin(), corners.begin() + i + 1);
  triangulate(loop, half, triangles);
}

}  // namespace

Triangles triangulate(const std::vector<Vec3>& loop) {
  if (loop.size() == 3) return {{0, 1, 2}};
  Triangles triangles;
  std::vector<int> corners(loop.size());
  std::iota(corners.begin(), corners.end(), 0);
  triangulate(loop, corners, &triangles);
  return triangles;
}

}  // namespace incision
