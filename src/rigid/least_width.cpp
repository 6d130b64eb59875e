#include "least_width.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <utility>

namespace incision {
namespace {

constexpr int ALL_ROUND = 500;                         // normals over half a sphere, 0.1 rad from one to the next
constexpr int BEST = 8;                                // of all, are turned on until they are narrowest
constexpr double FIRST_TURN = 0.05, LAST_TURN = 1e-9;  // [rad]
constexpr int MOST_TURNS = 20;  // of one size: what is not there then comes nearer by smaller ones

using Width = std::pair<double, Vec3>;

Width widthAlong(const std::function<double(const Vec3&)>& reach_along, const Vec3& n) {
  return {reach_along(n) + reach_along(-n), n};
}

/// Turns the normal as long as that makes it narrower, by half as much when it no longer does.
Width narrowest(const std::function<double(const Vec3&)>& reach_along, Width best) {
  for (double turn = FIRST_TURN; turn > LAST_TURN; turn /= 2) {
    bool better = true;
    for (int turns = 0; better && turns < MOST_TURNS; ++turns) {
      better = false;
      const Vec3 x = best.second.unitOrthogonal(), y = best.second.cross(x);
      for (int i = 0; i < 8; ++i) {
        const Vec3 aside = std::cos(M_PI / 4 * i) * x + std::sin(M_PI / 4 * i) * y;
        const Width tried = widthAlong(reach_along, (best.second + turn * aside).normalized());
        if (!(tried.first < best.first)) continue;
        best = tried;
        better = true;
        break;
      }
    }
  }
  return best;
}

}  // namespace

double leastWidth(const std::function<double(const Vec3&)>& reach_along, const std::vector<Vec3>& likely) {
  std::vector<Width> widths;
  for (const Vec3& n : likely) widths.push_back(widthAlong(reach_along, n));
  for (int i = 0; i < ALL_ROUND; ++i) {  // on a spiral round the z axis, whose turns are as far apart as its points
    const double z = (i + 0.5) / ALL_ROUND, angle = i * M_PI * (3 - std::sqrt(5));
    const double r = std::sqrt(1 - z * z);
    widths.push_back(widthAlong(reach_along, Vec3(r * std::cos(angle), r * std::sin(angle), z)));
  }
  const auto narrower = [](const Width& a, const Width& b) { return a.first < b.first; };
  const auto end = widths.begin() + std::min<std::ptrdiff_t>(BEST, static_cast<std::ptrdiff_t>(widths.size()));
  std::partial_sort(widths.begin(), end, widths.end(), narrower);
  double least = widths[0].first;
  for (auto it = widths.begin(); it != end; ++it) least = std::min(least, narrowest(reach_along, *it).first);
  return least;
}

}  // namespace incision
