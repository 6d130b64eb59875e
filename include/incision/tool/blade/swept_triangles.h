#pragma once

#include <Eigen/Geometry>
#include <algorithm>
#include <memory>
#include <utility>
#include <vector>

#include "incision/base/lists.h"
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

  Span<const SweptTriangle> all() const {
    return triangles_ ? Span<const SweptTriangle>(triangles_->data(), triangles_->data() + triangles_->size())
                      : Span<const SweptTriangle>(nullptr, nullptr);
  }

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

/// Triangles as they are seen along a direction, but for those that lie beside all of some points.
class SweptShadow {
 public:
  /// The triangles must outlive this.
  SweptShadow(Span<const SweptTriangle> triangles, const Vec3& direction, const std::vector<Barycentric>& points);

  bool isEmpty() const { return triangles_.empty(); }

  /// Whether isBehind holds for a triangle that counts(triangle) and one of the points, or one between them.
  template <typename Counts>
  bool covers(const Barycentric& point, const Counts& counts) const {
    const Eigen::Vector2d at = seen(point);
    return std::any_of(triangles_.begin(), triangles_.end(), [&](const Seen& seen) {
      return seen.box.contains(at) && isBehind(*seen.triangle, point, direction_) && counts(*seen.triangle);
    });
  }
  bool covers(const Barycentric& point) const {
    return covers(point, [](const SweptTriangle&) { return true; });
  }

 private:
  struct Seen {
    const SweptTriangle* triangle;
    Eigen::AlignedBox2d box;
  };

  Eigen::Vector2d seen(const Barycentric& point) const { return axes_ * point.tail<3>(); }

  Vec3 direction_;
  Eigen::Matrix<double, 2, 3> axes_;
  std::vector<Seen> triangles_;
};

}  // namespace incision
