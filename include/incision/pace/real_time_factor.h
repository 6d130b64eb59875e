#pragma once

#include <deque>

#include "incision/pace/command.h"

namespace incision {

/// Simulated time over wall time, of about the last second.
class RealTimeFactor {
 public:
  void restart() { samples_.clear(); }
  /// After each step: simulated time [s] now.
  void add(SteadyTime now, double simulated);
  /// 0 before the second step.
  double value() const;

 private:
  struct Sample {
    SteadyTime wall;
    double simulated;
  };
  std::deque<Sample> samples_;
};

}  // namespace incision
