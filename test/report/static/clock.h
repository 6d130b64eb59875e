#pragma once

#include <algorithm>
#include <chrono>
#include <vector>

namespace incision::report {

/// Wall time since it was made.
class Clock {
 public:
  double ms() const {
    return std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now() - start_).count();
  }

 private:
  std::chrono::steady_clock::time_point start_ = std::chrono::steady_clock::now();
};

/// Median wall time [ms] of so many runs, or of the only run where that takes long.
template <typename Run>
double medianTime(int repeats, const Run& run) {
  constexpr double LONG = 1000;  // [ms]
  std::vector<double> times;
  do {
    const Clock clock;
    run();
    times.push_back(clock.ms());
  } while (static_cast<int>(times.size()) < repeats && times[0] < LONG);
  std::sort(times.begin(), times.end());
  return times[times.size() / 2];
}

}  // namespace incision::report
