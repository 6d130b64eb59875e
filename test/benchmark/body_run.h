#pragma once

#include <string>
#include <vector>

#include "benchmark/table.h"
#include "incision/body/deformable_body.h"

namespace incision::bench {

/// How many steps are taken, and how many after them are measured.
struct StepCounts {
  int warm_up, measured;
};

/// Takes steps of an uncut body. The row holds "elements", "dofs", "load_s" (mesh and body), what `summary` gives, and
/// "state_hash" at the end.
Json runBody(const Scene& scene, const StepCounts& counts);

/// Which steps of a scene with cuts are measured.
struct CutWindows {
  int before, after;    ///< steps right before the first cut and right after the last one
  int later, at_later;  ///< steps that begin `at_later` steps after the last cut; 0: none
};

/// Takes steps through all cuts of a scene. The row holds sizes before and after, "load_s" (mesh and body), "first_ms"
/// of the first step, the summaries "before", "cut" (of the steps that cut), "after" and "later", and "hitch": the time
/// of each of HITCH steps [ms], of which the HITCH_BEFORE + 1st is the first that cuts.
Json runCuts(const Scene& scene, const CutWindows& windows);
inline constexpr int HITCH = 20, HITCH_BEFORE = 5;

/// Of `count` steps: "median_ms", "p99_ms", "phase_ms" (means of the phases), "iterations" (mean).
Json summary(const std::vector<StepResult>& steps, std::size_t first, std::size_t count);

}  // namespace incision::bench
