#include "incision/run/first_steps.h"

#include <algorithm>
#include <iomanip>
#include <sstream>

namespace incision {
namespace {

constexpr std::size_t COUNT = 10;

double median(std::vector<double> values) {
  std::sort(values.begin(), values.end());
  const std::size_t half = values.size() / 2;
  return values.size() % 2 == 1 ? values[half] : (values[half - 1] + values[half]) / 2;
}

}  // namespace

std::string paceInWords(double simulated, double taken) {
  std::ostringstream words;
  words << std::setprecision(2);
  if (simulated >= taken)
    words << simulated / taken << " times as fast as real time";
  else
    words << simulated / taken << " of real time";
  return words.str();
}

std::optional<std::string> FirstSteps::add(double step_ms) {
  if (step_ms_.size() >= COUNT) return std::nullopt;
  step_ms_.push_back(step_ms);
  if (step_ms_.size() < COUNT) return std::nullopt;
  const double simulated = 1e3 * time_step_, taken = median(step_ms_);
  std::ostringstream line;
  line << "a step of " << std::setprecision(6) << simulated << " ms takes " << std::setprecision(2) << taken
       << " ms (median of the first ten): " << paceInWords(simulated, taken);
  return line.str();
}

}  // namespace incision
