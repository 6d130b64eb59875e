#pragma once

#include <functional>
#include <string>
#include <vector>

#include "benchmark/table.h"

namespace incision::bench {

/// A run that is measured beside others.
struct Run {
  std::string name;
  std::function<Json()> work;
  bool slow = false;  ///< taken in the first round only
};

/// Takes the runs in turn, `rounds` times, each in a process of its own, and keeps of each the round with the lowest
/// value at `pointer`: other programs can only slow a run down, and what they do meets all runs alike.
std::vector<Json> bestOfRounds(const std::vector<Run>& runs, int rounds, const std::string& pointer = "/median_ms");

}  // namespace incision::bench
