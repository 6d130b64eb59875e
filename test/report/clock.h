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

inline double median(std::vector<double> values) {
  const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
  std::nth_element(values.begin(), middle, values.end());
  return *middle;
}

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
  return median(times);
}

}  // namespace incision::report
