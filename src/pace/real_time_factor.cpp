#include "incision/pace/real_time_factor.h"

namespace incision {

void RealTimeFactor::add(SteadyTime now, double simulated) {
  samples_.push_back({now, simulated});
  while (samples_.size() > 2 && now - samples_.front().wall > std::chrono::seconds(1)) samples_.pop_front();
}

double RealTimeFactor::value() const {
  if (samples_.size() < 2) return 0;
  const std::chrono::duration<double> wall = samples_.back().wall - samples_.front().wall;
  return (samples_.back().simulated - samples_.front().simulated) / wall.count();
}

}  // namespace incision
