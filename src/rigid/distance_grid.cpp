#include "incision/rigid/distance_grid.h"

#include <cmath>
#include <limits>

namespace incision {

DistanceGrid::DistanceGrid(const Eigen::AlignedBox3d& box, int cells,
                           const std::function<double(const Vec3&)>& distance)
    : box_(box), width_(box.sizes().maxCoeff() / cells) {
  count_ = (box.sizes() / width_).array().ceil().cast<int>().max(1);
  for (int k = 0; k < count_.z(); ++k)
    for (int j = 0; j < count_.y(); ++j)
      for (int i = 0; i < count_.x(); ++i) {
        const auto rounded = static_cast<float>(distance(centreOf({i, j, k})));
        distances_.push_back(std::nextafter(rounded, -std::numeric_limits<float>::infinity()));
      }
}

Vec3 DistanceGrid::centreOf(const Eigen::Array3i& cell) const {
  return box_.min() + width_ * (cell.cast<double>() + 0.5).matrix();
}

std::size_t DistanceGrid::indexOf(const Eigen::Array3i& cell) const {
  return static_cast<std::size_t>((cell.z() * count_.y() + cell.y()) * count_.x() + cell.x());
}

// From one point to another a distance changes by no more than the way.
bool DistanceGrid::isClearOf(const Vec3& point, double room) const {
  const double outside = box_.squaredExteriorDistance(point);
  if (outside > room * room) return true;
  if (outside > 0) return false;
  const Eigen::Array3i cell = ((point - box_.min()) / width_).array().cast<int>().min(count_ - 1);
  return static_cast<double>(distances_[indexOf(cell)]) - (point - centreOf(cell)).norm() > room;
}

}  // namespace incision
