#include "incision/tool/blade/sweep.h"

#include <algorithm>
#include <cmath>

#include "incision/cut/section.h"

namespace incision {
namespace {

/// Rim of a triangle, as a share of it, that counts as inside: consecutive sweeps share an edge, and a point on it must
/// not fall between.
constexpr double RIM = 1e-9;

/// Points that stand for a polygon: each is a hundredth of what ties it.
constexpr int POINTS = 96;

/// Of the sequence of Roberts (2018), the two-dimensional golden ratio: frac(k g), frac(k g²) fill the square evenly.
constexpr double GOLDEN = 0.7548776662466927;

/// What half spaces, one after the other, leave of a triangle.
class Clipped {
 public:
  explicit Clipped(const SweptTriangle& triangle) : count_(triangle.size()) {
    std::copy(triangle.begin(), triangle.end(), corners_.begin());
  }

  bool isEmpty() const { return count_ == 0; }

  /// Keeps what lies where `inside`, which is affine, is not negative; all, where that could take too many corners.
  template <typename Inside>
  void by(const Inside& inside) {
    if (count_ == MOST) return;
    std::array<Barycentric, MOST> left;
    std::size_t kept = 0;  // one half space adds no more than one corner
    for (std::size_t i = 0; i < count_; ++i) {
      const Barycentric &a = corners_[i], &b = corners_[(i + 1) % count_];
      const double inside_a = inside(a), inside_b = inside(b);
      if (inside_a >= 0) left[kept++] = a;
      if ((inside_a < 0) != (inside_b < 0)) left[kept++] = a + inside_a / (inside_a - inside_b) * (b - a);
    }
    std::copy(left.begin(), left.begin() + static_cast<std::ptrdiff_t>(kept), corners_.begin());
    count_ = kept;
  }

 private:
  static constexpr std::size_t MOST = 24;
  std::array<Barycentric, MOST> corners_;
  std::size_t count_;
};

double fraction(double value) { return value - std::floor(value); }

double areaOf(const Barycentric& a, const Barycentric& b, const Barycentric& c) {
  return (b - a).tail<3>().cross((c - a).tail<3>()).norm();
}

}  // namespace

bool isBehind(const SweptTriangle& triangle, const Barycentric& point, const Vec3& direction) {
  std::array<double, 3> side;  // twice the areas that the point's image cuts the triangle's into
  for (int i = 0; i < 3; ++i) {
    const Vec3 a = (triangle[i] - point).tail<3>(), b = (triangle[(i + 1) % 3] - point).tail<3>();
    side[i] = a.cross(b).dot(direction);
  }
  const double area = side[0] + side[1] + side[2], rim = RIM * std::abs(area), sense = area < 0 ? -1 : 1;
  return area != 0 && std::all_of(side.begin(), side.end(), [&](double s) { return sense * s >= -rim; });
}

bool reaches(const SweptTriangle& triangle, double margin) {
  Clipped clipped(triangle);
  for (int I = 0; I < 4; ++I) clipped.by([&](const Barycentric& b) { return b[I] + margin; });
  return !clipped.isEmpty();
}

bool reaches(const SweptTriangle& triangle, const Polytope& polytope) {
  Clipped clipped(triangle);
  for (const Facet& facet : polytope.facets) {
    const Vec3 out = vectorArea(polytope, facet, [](const Barycentric& b) -> Vec3 { return b.tail<3>(); });
    const Barycentric& base = polytope.corners[facet.corners[0]];
    clipped.by([&](const Barycentric& b) { return out.dot((base - b).tail<3>()); });
  }
  return !clipped.isEmpty();
}

Vec3 gradient(const Eigen::Vector4d& phi) { return phi.tail<3>() - Vec3::Constant(phi[0]); }

/// The first coordinate chooses a triangle of the fan by area and what is left of it goes on as that of the triangle.
std::vector<Barycentric> spread(const std::vector<Barycentric>& polygon) {
  std::vector<double> upTo = {0};
  for (std::size_t i = 2; i < polygon.size(); ++i)
    upTo.push_back(upTo.back() + areaOf(polygon[0], polygon[i - 1], polygon[i]));
  std::vector<Barycentric> points;
  for (int k = 0; k < POINTS; ++k) {
    const double u = fraction(0.5 + k * GOLDEN) * upTo.back(), v = fraction(0.5 + k * GOLDEN * GOLDEN);
    const auto next = std::upper_bound(upTo.begin() + 1, upTo.end() - 1, u);
    const std::size_t i = static_cast<std::size_t>(next - upTo.begin());
    const double width = upTo[i] - upTo[i - 1];
    const double r = std::sqrt(width > 0 ? std::clamp((u - upTo[i - 1]) / width, 0.0, 1.0) : 0.5);
    points.push_back((1 - r) * polygon[0] + r * ((1 - v) * polygon[i] + v * polygon[i + 1]));
  }
  return points;
}

Vec3 nearest(const Edge& edge, const Vec3& point) {
  const Vec3 along = edge[1] - edge[0];
  return edge[0] + (point - edge[0]).dot(along) / along.squaredNorm() * along;
}

double shortestEdge(const Part& part, const CutMesh& mesh) {
  double shortest = mesh.shortestEdge(mesh.copyNode(part.copies[0]));
  for (int I = 1; I < 4; ++I) shortest = std::min(shortest, mesh.shortestEdge(mesh.copyNode(part.copies[I])));
  return shortest;
}

bool touches(const Edge& edge, const std::vector<Vec3>& x, const CutMesh& mesh, NearParts* near) {
  Eigen::AlignedBox3d reach(edge[0]);
  reach.extend(edge[1]);
  const std::vector<int>& parts = near->find(reach, 0, x);
  return std::any_of(parts.begin(), parts.end(), [&](int p) {
    const Part& part = mesh.parts()[p];
    if (!reach.intersects(boxOf(part, x))) return false;
    const PartFrame frame(part, x);
    if (!frame.invertible()) return false;
    const Barycentric a = frame.toElement(edge[0]), b = frame.toElement(edge[1]);
    double first = 0, last = 1;  // of the edge, what lies in the element
    for (int I = 0; I < 4; ++I) {
      if (a[I] < 0 && b[I] < 0) return false;
      if (a[I] < 0) first = std::max(first, a[I] / (a[I] - b[I]));
      if (b[I] < 0) last = std::min(last, a[I] / (a[I] - b[I]));
    }
    return first <= last;
  });
}

}  // namespace incision
