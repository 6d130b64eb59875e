#pragma once

#include <Eigen/Geometry>
#include <memory>
#include <utility>
#include <vector>

#include "incision/tool/blade/sweep.h"

namespace incision {

/// What edges have swept of an element so far: the newest triangles, in the order in which they came. Copies share
/// them, since a stroke is kept before each step and few elements are swept in one.
class SweptTriangles {
 public:
  /// Triangles that are kept; the oldest go first. An element is cut by the first of the sweeps that enter it; these
  /// tell what the last element of the way was.
  static constexpr std::size_t MOST = 128;

  /// Adds those of one sweep. Nothing has changed where it throws.
  void add(const std::vector<SweptTriangle>& more);

  const SweptTriangle* begin() const { return triangles_ ? triangles_->data() : nullptr; }
  const SweptTriangle* end() const { return triangles_ ? triangles_->data() + triangles_->size() : nullptr; }

  template <class Archive>
  void save(Archive& archive) const {
    archive(triangles_ ? *triangles_ : std::vector<SweptTriangle>());
  }
  template <class Archive>
  void load(Archive& archive) {
    std::vector<SweptTriangle> triangles;
    archive(triangles);
    triangles_ = std::make_shared<const std::vector<SweptTriangle>>(std::move(triangles));
  }

 private:
  std::shared_ptr<const std::vector<SweptTriangle>> triangles_;
};

/// Triangles as they are seen along a direction, but for those that lie beside a polygon.
class SweptShadow {
 public:
  SweptShadow(const SweptTriangles& triangles, const Vec3& direction, const std::vector<Barycentric>& polygon);

  bool isEmpty() const { return triangles_.empty(); }

  /// Whether isBehind holds for a triangle and a point of the polygon.
  bool covers(const Barycentric& point) const;

 private:
  struct Seen {
    const SweptTriangle* triangle;
    Eigen::AlignedBox2d box;
  };

  Eigen::Vector2d seen(const Barycentric& point) const;

  Vec3 direction_;
  Eigen::Matrix<double, 2, 3> axes_;
  std::vector<Seen> triangles_;
};

}  // namespace incision
