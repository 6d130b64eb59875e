#include "incision/solver/backward_difference.h"

#include <utility>

namespace incision {

bool BackwardDifference::advance(double time, double time_step, ImplicitStep* step, Motion* motion) {
  start_ = *motion;
  if (memory_.known) {
    step->beginSecondOrder(time_step, *motion, memory_.before);
    if (!step->advance(time + time_step / 3, motion)) return false;
  } else {
    step->beginAhead(time_step, *motion);
    if (!step->advance(time, motion)) return false;
  }
  std::swap(memory_.before, start_);
  memory_.known = true;
  return true;
}

}  // namespace incision
