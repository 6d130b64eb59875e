#include "incision/solver/backward_difference.h"

namespace incision {

bool BackwardDifference::advance(double time, double time_step, ImplicitStep* step, Motion* motion) {
  const std::size_t copies = motion->x.size();
  ahead_.resize(copies);
  for (std::size_t c = 0; c < copies; ++c) ahead_[c] = motion->x[c] + time_step * motion->v[c];
  if (!memory_.known) {
    start_ = *motion;
    if (!step->advance(time, time_step, motion, nullptr, &ahead_)) return false;
    std::swap(memory_.before, start_);
    memory_.known = true;
    return true;
  }
  start_.x.resize(copies);
  start_.v.resize(copies);
  for (std::size_t c = 0; c < copies; ++c) {
    start_.x[c] = motion->x[c] + (motion->x[c] - memory_.before.x[c]) / 3;
    start_.v[c] = motion->v[c] + (motion->v[c] - memory_.before.v[c]) / 3;
  }
  if (!step->advance(time + time_step / 3, 2 * time_step / 3, &start_, nullptr, &ahead_)) return false;
  std::swap(memory_.before, *motion);
  std::swap(*motion, start_);
  return true;
}

}  // namespace incision
