#pragma once

#include <functional>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "incision/body/deformable_body.h"

namespace incision::report {

/// What a program that measures is asked for: SCENE.yaml FIRST STEPS [KEY=VALUE]...
struct CostOptions {
  std::string scene;
  int first = 0;  ///< steps before those that are measured
  int steps = 1;  ///< that are measured
  std::vector<std::string> overrides;
};

/// Throws std::runtime_error with the usage when an argument is missing.
CostOptions costOptions(int argc, char** argv);

/// What is done with a body besides its steps; either may be empty.
struct Besides {
  std::function<void(const DeformableBody&)> set_up;   ///< once, before the steps
  std::function<void(const DeformableBody&)> in_step;  ///< after each step, as a part of it
  std::function<void(const DeformableBody&)> between;  ///< after that, not timed
};

/// Runs the scene. Of the measured steps: `step_ms` and `iterations`, `contacts`, `cracks`, `cuts` of each, and
/// `allocations` of one in the mean. At the end: `bytes` of the heap that the body holds, `elements`, `copies` and
/// `pieces`. callgrind counts in these steps alone when it starts with --instr-atstart=no.
nlohmann::json costOf(const CostOptions& options, const Besides& besides = {});

}  // namespace incision::report
