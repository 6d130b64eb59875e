#include "incision/ros/force_scale.h"

#include <algorithm>
#include <cmath>

namespace incision {
namespace {

/// Of the arrow of the largest force of late, in sizes of the body.
constexpr double LONGEST_ARROW = 1.0 / 3, SHORTEST_ARROW = LONGEST_ARROW / 10;

/// In this time [s] half of a force is forgotten: the blow of one step is, within some of it, and the pause between two
/// cuts is not.
constexpr double HALF_LIFE = 5;

/// The largest of 1, 2 and 5 times a power of ten that is not above a value above 0.
double stepBelow(double value) {
  constexpr double A_LITTLE = 1 + 1e-12;  // or a 2 may be taken for less
  const double power = std::pow(10, std::floor(std::log10(value)));
  for (const double step : {5, 2})
    if (step * power <= value * A_LITTLE) return step * power;
  return power;
}

}  // namespace

ForceScale::ForceScale(double size, double least) : size_(size), least_(least), peak_(least) {}

double ForceScale::at(double time, double force) {
  if (time < time_) peak_ = least_;  // the body has become another
  const double faded = peak_ * std::exp2(-std::max(time - time_, 0.0) / HALF_LIFE);
  time_ = time;
  peak_ = std::max({faded, force, least_});
  const double length = scale_ * peak_;
  if (length > LONGEST_ARROW * size_ || length < SHORTEST_ARROW * size_)
    scale_ = stepBelow(LONGEST_ARROW * size_ / peak_);
  return scale_;
}

}  // namespace incision
