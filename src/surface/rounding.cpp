#include "incision/surface/rounding.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <utility>

#include "incision/base/disjoint_sets.h"
#include "incision/surface/vertex_fields.h"

namespace incision {
namespace {

/// A side at which the two triangles of the resting skin turn by more than this [rad], 50 degrees, is meant to be
/// sharp: a box turns by 90 degrees, a ball of 20 triangles by 42.
constexpr double SHARP = 0.87;

/// The cosine of the turn, now, down to which a side bends in full; at 0, a right angle, it no longer does. So a fold
/// in the skin is drawn as a fold, and nothing jumps while it comes.
constexpr double BENDS_IN_FULL = 0.5;

std::vector<Vec3> triangleNormals(const Surface& surface, const std::vector<Vec3>& x) {
  std::vector<Vec3> normals;
  normals.reserve(surface.triangles.size());
  for (const auto& triangle : surface.triangles) normals.push_back(vectorArea(triangle, x).stableNormalized());
  return normals;
}

/// Which corner of a triangle is at a vertex.
int cornerAt(const std::array<int, 3>& triangle, int vertex) {
  return static_cast<int>(std::find(triangle.begin(), triangle.end(), vertex) - triangle.begin());
}

}  // namespace

Rounding::Rounding(const Surface& surface, const std::vector<Vec3>& rest) {
  findSides(surface);
  const std::vector<Vec3> normals = triangleNormals(surface, rest);
  for (Side& side : sides_of_all_) {
    const auto [a, b] = side.triangles;
    side.bends = side.bends && normals[a].dot(normals[b]) > std::cos(SHARP);
  }
  findFans(surface);
}

/// A side bends, as far as the topology goes, where two triangles of the skin meet and no others.
void Rounding::findSides(const Surface& surface) {
  struct Use {
    std::array<int, 2> ends;
    int triangle, at;
  };
  std::vector<Use> uses;
  for (int t = 0; t < static_cast<int>(surface.triangles.size()); ++t)
    for (int i = 0; i < 3; ++i) {
      const auto [low, high] = std::minmax(surface.triangles[t][i], surface.triangles[t][(i + 1) % 3]);
      uses.push_back({{low, high}, t, i});
    }
  std::stable_sort(uses.begin(), uses.end(), [](const Use& a, const Use& b) { return a.ends < b.ends; });
  sides_.resize(surface.triangles.size());
  for (std::size_t first = 0, last = 0; first < uses.size(); first = last) {
    while (last < uses.size() && uses[last].ends == uses[first].ends) ++last;
    Side side{uses[first].ends, {uses[first].triangle, uses[last - 1].triangle}, {}, last - first == 2};
    for (std::size_t i = first; i < last; ++i) {
      side.bends = side.bends && !surface.cut_face[uses[i].triangle];
      sides_[uses[i].triangle][uses[i].at] = static_cast<int>(sides_of_all_.size());
    }
    sides_of_all_.push_back(side);
  }
}

void Rounding::findFans(const Surface& surface) {
  const auto corner = [&](int triangle, int vertex) {
    return 3 * triangle + cornerAt(surface.triangles[triangle], vertex);
  };
  DisjointSets fans(3 * static_cast<int>(surface.triangles.size()));
  for (const Side& side : sides_of_all_)
    if (side.bends)
      for (const int end : side.ends) fans.join(corner(side.triangles[0], end), corner(side.triangles[1], end));
  fans_ = fans.enumerate(&fan_of_corner_);
  for (Side& side : sides_of_all_)
    for (int i = 0; i < 2; ++i) side.fans[i] = fan_of_corner_[corner(side.triangles[0], side.ends[i])];
}

std::vector<Vec3> Rounding::middles(const Surface& surface, const std::vector<Vec3>& x) const {
  std::vector<Vec3> of_triangles = triangleNormals(surface, x), of_fans(fans_, Vec3::Zero());
  for (std::size_t t = 0; t < surface.triangles.size(); ++t) {
    const Vec3 area = vectorArea(surface.triangles[t], x);
    for (int i = 0; i < 3; ++i) of_fans[fan_of_corner_[3 * t + i]] += area;
  }
  for (Vec3& normal : of_fans) normal.stableNormalize();
  std::vector<Vec3> middles;
  middles.reserve(sides_of_all_.size());
  for (const Side& side : sides_of_all_) {
    const Vec3 &a = x[side.ends[0]], &b = x[side.ends[1]];
    middles.push_back((a + b) / 2);
    if (!side.bends) continue;
    const double turn = of_triangles[side.triangles[0]].dot(of_triangles[side.triangles[1]]);
    const Vec3 &at_a = of_fans[side.fans[0]], &at_b = of_fans[side.fans[1]];
    const Vec3 out = (b - a).dot(at_a) * at_a + (a - b).dot(at_b) * at_b;
    middles.back() -= std::clamp(turn / BENDS_IN_FULL, 0.0, 1.0) / 8 * out;
  }
  return middles;
}

}  // namespace incision
