#include "capsule_points.h"

#include <cmath>

#include "incision/ros/conversions.h"

namespace incision {
namespace {

/// How finely a capsule is drawn: round the axis, and along a half of it.
constexpr int SIDES = 24, RINGS = 6;

}  // namespace

std::vector<geometry_msgs::Point> capsulePoints(const Vec3& size) {
  const double radius = size.x() / 2, half_length = size.z() / 2 - radius;
  // Rings from the lower end to the upper one; those of the two half spheres that are widest bound the cylinder.
  const auto corner = [&](int ring, int side) {
    const bool is_above = ring > RINGS;
    const double up = M_PI / 2 * (is_above ? ring - 1 - RINGS : ring - RINGS) / RINGS, round = 2 * M_PI * side / SIDES;
    const double r = radius * std::cos(up), z = radius * std::sin(up) + (is_above ? half_length : -half_length);
    return toPoint(Vec3(r * std::cos(round), r * std::sin(round), z));
  };
  std::vector<geometry_msgs::Point> points;
  for (int ring = 0; ring <= 2 * RINGS; ++ring)
    for (int side = 0; side < SIDES; ++side)
      for (const auto& [r, s] : {std::pair(0, 0), {0, 1}, {1, 1}, {0, 0}, {1, 1}, {1, 0}})
        points.push_back(corner(ring + r, side + s));
  return points;
}

}  // namespace incision
