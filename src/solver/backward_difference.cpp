#include "incision/solver/backward_difference.h"

namespace incision {

bool BackwardDifference::advance(double time, double time_step, ImplicitStep* step, Motion* motion) {
  const std::size_t copies = motion->x.size();
  ahead_.resize(copies);
  for (std::size_t c = 0; c < copies; ++c) ahead_[c] = motion->x[c] + time_step * motion->v[c];
  if (!known_) {
    before_ = *motion;
    known_ = step->advance(time, time_step, motion, {}, &ahead_);
    return known_;
  }
  start_.x.resize(copies);
  start_.v.resize(copies);
  for (std::size_t c = 0; c < copies; ++c) {
    start_.x[c] = motion->x[c] + (motion->x[c] - before_.x[c]) / 3;
    start_.v[c] = motion->v[c] + (motion->v[c] - before_.v[c]) / 3;
  }
  known_ = step->advance(time + time_step / 3, 2 * time_step / 3, &start_, {}, &ahead_);
  if (!known_) return false;
  std::swap(before_, *motion);
  std::swap(*motion, start_);
  return true;
}

}  // namespace incision
