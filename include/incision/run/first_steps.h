#pragma once

#include <optional>
#include <string>
#include <vector>

namespace incision {

/// "1.25 times as fast as real time" or "0.8 of real time": how long steps take beside what they simulate, both in the
/// same unit and above 0.
std::string paceInWords(double simulated, double taken);

/// What pace is to be expected, told once after the first ten steps. Their median is that of a step: the first one
/// makes room for all that follow, and one may have a cut in it.
class FirstSteps {
 public:
  /// [s]
  explicit FirstSteps(double time_step) : time_step_(time_step) {}

  /// After each step, with how long it took [ms]: after the tenth a line for people, else nothing.
  std::optional<std::string> add(double step_ms);

 private:
  const double time_step_;
  std::vector<double> step_ms_;
};

}  // namespace incision
