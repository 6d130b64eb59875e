#include "incision/tool/grasper/spread_out.h"

#include <algorithm>
#include <limits>

namespace incision {

std::vector<int> spreadOut(const std::vector<Vec3>& points, std::size_t most) {
  std::vector<int> chosen;
  std::vector<double> away(points.size(), std::numeric_limits<double>::infinity());  // squared, from those chosen
  while (chosen.size() < std::min(most, points.size())) {
    const auto farthest = std::max_element(away.begin(), away.end());
    if (*farthest == 0) break;
    chosen.push_back(static_cast<int>(farthest - away.begin()));
    const Vec3& last = points[chosen.back()];
    for (std::size_t i = 0; i < points.size(); ++i) away[i] = std::min(away[i], (points[i] - last).squaredNorm());
  }
  return chosen;
}

}  // namespace incision
