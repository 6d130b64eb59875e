#include "incision/run/step_tally.h"

#include <algorithm>
#include <cmath>

#include "incision/base/yaml_reader.h"

namespace incision {

void StepTally::add(const StepResult& step) {
  ++steps;
  unsettled += step.settled ? 0 : 1;
  divided += step.divided ? 1 : 0;
  step_ms += step.step_ms;
  longest_ms = std::max(longest_ms, step.step_ms);
  phase_ms += step.phase_ms;
  residual = std::max(residual, step.residual);
  iterations = std::max(iterations, step.iterations);
}

std::vector<PhaseShare> sharesOf(const StepTally& tally) {
  constexpr double LEAST_SHARE = 0.01;  // less says nothing to anyone
  if (tally.step_ms <= 0) return {};
  const auto& [cut, fracture, contact, assembly, solve, update] = tally.phase_ms;
  std::vector<PhaseShare> shares;
  for (const auto& [phase, ms] :
       {std::pair("cuts", cut), std::pair("fracture", fracture), std::pair("contact", contact),
        std::pair("assembly", assembly), std::pair("solve", solve), std::pair("update", update)})
    if (ms >= LEAST_SHARE * tally.step_ms) shares.push_back({phase, ms / tally.step_ms});
  std::stable_sort(shares.begin(), shares.end(),
                   [](const PhaseShare& a, const PhaseShare& b) { return a.share > b.share; });
  return shares;
}

std::string describe(const std::vector<PhaseShare>& shares) {
  std::vector<std::string> words;
  for (const auto& [phase, share] : shares)
    words.push_back(phase + " " + std::to_string(std::lround(100 * share)) + " %");
  return joined(words);
}

}  // namespace incision
