#include "incision/pace/pose_path.h"

#include <limits>
#include <utility>

namespace incision {
namespace {

/// The points whose way matters: the link's origin and the edge's ends.
using Points = Eigen::Array<double, 9, 1>;

Points pointsOf(const Pose& pose, const Edge& edge) {
  const Edge ends = placed(edge, pose);
  Points points;
  points << pose.position, ends[0], ends[1];
  return points;
}

/// The velocities, a pose the unit of time, with which the points pass all poses met so far within the tolerance.
class Cone {
 public:
  explicit Cone(const Points& apex) : apex_(apex) {}

  /// Whether the way straight to the next pose passes all before it. They narrow the cone only then.
  bool reaches(const Points& next) {
    ++poses_;
    const Points velocity = (next - apex_) / poses_;
    if ((velocity < low_).any() || (velocity > high_).any()) return false;
    low_ = low_.max(velocity - PATH_TOLERANCE / poses_);
    high_ = high_.min(velocity + PATH_TOLERANCE / poses_);
    return true;
  }

 private:
  Points apex_;
  double poses_ = 0;
  Points low_ = Points::Constant(-std::numeric_limits<double>::infinity());
  Points high_ = Points::Constant(std::numeric_limits<double>::infinity());
};

}  // namespace

double travel(const Pose& from, const Pose& to, const Edge& edge) {
  const Points way = pointsOf(to, edge) - pointsOf(from, edge);
  return way.reshaped<Eigen::ColMajor>(3, 3).matrix().colwise().norm().maxCoeff();
}

std::vector<Pose> simplified(const Pose& from, const std::vector<Pose>& path, const Edge& edge) {
  std::vector<Pose> kept;
  Points last = pointsOf(from, edge);
  Cone cone(last);
  for (std::size_t i = 0; i < path.size(); ++i) {
    const Points points = pointsOf(path[i], edge);
    if (!cone.reaches(points)) {
      kept.push_back(path[i - 1]);
      cone = Cone(last);
      cone.reaches(points);
    }
    last = points;
  }
  if (!path.empty()) kept.push_back(path.back());
  return kept;
}

std::vector<Pose> takeFront(double share, const Pose& from, const Edge& edge, std::vector<Pose>* way) {
  if (share >= 1) return std::exchange(*way, {});
  double to_take = 0;  // [m]
  for (std::size_t i = 0; i < way->size(); ++i)
    to_take += share * travel(i == 0 ? from : (*way)[i - 1], (*way)[i], edge);
  std::vector<Pose> taken;
  auto next = way->begin();
  for (Pose last = from; next != way->end(); last = *next++) {
    const double section = travel(last, *next, edge);
    if (section > to_take) {
      taken.push_back(between(last, *next, to_take / section));
      break;
    }
    to_take -= section;
    taken.push_back(*next);
  }
  way->erase(way->begin(), next);
  return taken;
}

}  // namespace incision
