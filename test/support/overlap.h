#pragma once

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>
#include <vector>

#include "incision/base/disjoint_sets.h"
#include "incision/surface/surface.h"

namespace incision::test {

/// How deep fragments overlap, by winding numbers: it knows nothing of how contact is found.
class Overlap {
 public:
  /// The surface's vertices stand at `x` [m].
  Overlap(const Surface& surface, const std::vector<Vec3>& x) : x_(x) {
    DisjointSets sets(static_cast<int>(x.size()));
    for (const auto& t : surface.triangles)
      for (int k : {1, 2}) sets.join(t[0], t[k]);
    std::vector<int> set_of;
    fragments_.resize(sets.enumerate(&set_of));
    for (const auto& t : surface.triangles) {
      Fragment& fragment = fragments_[set_of[t[0]]];
      fragment.triangles.push_back(t);
      for (int v : t) fragment.extend(x[v]);
    }
  }

  /// The largest depth of a point of one fragment's surface in another fragment [m].
  double deepest() const {
    double deepest = 0;
    for (const Fragment& a : fragments_)
      for (const Fragment& b : fragments_)
        if (&a != &b) deepest = std::max(deepest, deepestIn(a, b, deepest));
    return deepest;
  }

 private:
  /// A fragment, and how far it goes in many directions: what is beyond lies outside, which saves most of the work.
  struct Fragment {
    std::vector<std::array<int, 3>> triangles;
    std::vector<double> reach = std::vector<double>(DIRECTIONS, -std::numeric_limits<double>::infinity());

    void extend(const Vec3& p) {
      for (int i = 0; i < DIRECTIONS; ++i) reach[i] = std::max(reach[i], direction(i).dot(p));
    }
    bool mayHoldDeeper(const Vec3& p, double depth) const {
      int i = 0;
      while (i < DIRECTIONS && reach[i] - direction(i).dot(p) > depth) ++i;
      return i == DIRECTIONS;
    }
  };

  static constexpr int DIRECTIONS = 200;

  /// Evenly round the sphere, along a spiral.
  static const Vec3& direction(int i) {
    static const std::vector<Vec3> directions = [] {
      std::vector<Vec3> made;
      for (int k = 0; k < DIRECTIONS; ++k) {
        const double z = 1 - (2 * k + 1.0) / DIRECTIONS, turn = k * M_PI * (3 - std::sqrt(5.0));
        made.push_back({std::sqrt(1 - z * z) * std::cos(turn), std::sqrt(1 - z * z) * std::sin(turn), z});
      }
      return made;
    }();
    return directions[i];
  }

  /// Points of each triangle: a lattice with so many steps along an edge.
  static constexpr int STEPS = 4;

  /// Or `deepest`, where there is none deeper.
  double deepestIn(const Fragment& a, const Fragment& b, double deepest) const {
    for (const auto& t : a.triangles)
      for (int i = 0; i <= STEPS; ++i)
        for (int k = 0; i + k <= STEPS; ++k) {
          const Vec3 p = (i * x_[t[0]] + k * x_[t[1]] + (STEPS - i - k) * x_[t[2]]) / STEPS;
          if (b.mayHoldDeeper(p, deepest) && windingNumber(b, p) > 0.5) deepest = std::max(deepest, distance(b, p));
        }
    return deepest;
  }

  /// How often a fragment's surface goes round a point: 1 inside, 0 outside (van Oosterom and Strackee, 1983).
  double windingNumber(const Fragment& fragment, const Vec3& p) const {
    double sum = 0;
    for (const auto& t : fragment.triangles) {
      const Vec3 a = x_[t[0]] - p, b = x_[t[1]] - p, c = x_[t[2]] - p;
      const double la = a.norm(), lb = b.norm(), lc = c.norm();
      sum += std::atan2(a.dot(b.cross(c)), la * lb * lc + a.dot(b) * lc + b.dot(c) * la + c.dot(a) * lb);
    }
    return sum / (2 * M_PI);
  }

  double distance(const Fragment& fragment, const Vec3& p) const {
    double nearest = std::numeric_limits<double>::infinity();
    for (const auto& t : fragment.triangles) nearest = std::min(nearest, toTriangle(x_[t[0]], x_[t[1]], x_[t[2]], p));
    return nearest;
  }

  static double toSegment(const Vec3& a, const Vec3& b, const Vec3& p) {
    const Vec3 along = b - a;
    const double share = std::clamp(along.dot(p - a) / std::max(along.squaredNorm(), 1e-300), 0.0, 1.0);
    return (p - a - share * along).norm();
  }

  static double toTriangle(const Vec3& a, const Vec3& b, const Vec3& c, const Vec3& p) {
    const Vec3 n = (b - a).cross(c - a).stableNormalized();
    const bool over =
        n.cross(b - a).dot(p - a) >= 0 && n.cross(c - b).dot(p - b) >= 0 && n.cross(a - c).dot(p - c) >= 0;
    if (over && !n.isZero(0)) return std::abs(n.dot(p - a));
    return std::min({toSegment(a, b, p), toSegment(b, c, p), toSegment(c, a, p)});
  }

  const std::vector<Vec3>& x_;
  std::vector<Fragment> fragments_;
};

}  // namespace incision::test
