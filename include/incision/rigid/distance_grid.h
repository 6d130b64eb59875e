#pragma once

#include <Eigen/Geometry>
#include <functional>
#include <vector>

#include "incision/base/vec.h"

namespace incision {

/// Distances from a solid at the centres of cells that fill a box round it: coarse, but quick to look up.
class DistanceGrid {
 public:
  DistanceGrid() = default;
  /// `cells` along the box's longest edge; the signed distance is asked once for each [m].
  DistanceGrid(const Eigen::AlignedBox3d& box, int cells, const std::function<double(const Vec3&)>& distance);

  /// Whether a point is surely further than `room` [m] from the solid: never wrong where it says so.
  bool isClearOf(const Vec3& point, double room) const;

 private:
  Vec3 centreOf(const Eigen::Array3i& cell) const;
  std::size_t indexOf(const Eigen::Array3i& cell) const;

  Eigen::AlignedBox3d box_;
  double width_ = 0;  // of a cell [m]
  Eigen::Array3i count_ = Eigen::Array3i::Zero();
  std::vector<float> distances_;  // [m], rounded down
};

}  // namespace incision
