#include "benchmark/body_run.h"

#include <algorithm>
#include <chrono>
#include <iterator>
#include <stdexcept>

#include "incision/run/run_summary.h"

namespace incision::bench {
namespace {

using Clock = std::chrono::steady_clock;

std::vector<StepResult> take(DeformableBody* body, int steps) {
  std::vector<StepResult> results;
  for (int k = 0; k < steps; ++k) results.push_back(body->step());
  return results;
}

Json phases(const PhaseTimes& times) {
  return {{"cut", times.cut},
          {"contact", times.contact},
          {"assembly", times.assembly},
          {"solve", times.solve},
          {"update", times.update}};
}

bool cuts(const StepResult& step) { return !step.cuts.empty(); }

double lastCutTime(const Scene& scene) {
  double last = 0;
  for (const ScheduledCut& cut : scene.cuts) last = std::max(last, cut.time);
  return last;
}

void requireApplied(const std::vector<StepResult>& steps) {
  for (const StepResult& step : steps)
    for (const CutResult& cut : step.cuts)
      if (cut.status != CutStatus::APPLIED) throw std::runtime_error("a cut was not applied: " + cut.reason);
}

std::vector<StepResult> thoseThatCut(const std::vector<StepResult>& steps) {
  std::vector<StepResult> found;
  std::copy_if(steps.begin(), steps.end(), std::back_inserter(found), cuts);
  return found;
}

}  // namespace

Json summary(const std::vector<StepResult>& steps, std::size_t first, std::size_t count) {
  StepStatistics statistics;
  double iterations = 0;
  for (std::size_t k = first; k < first + count; ++k) {
    statistics.add(steps.at(k));
    iterations += steps[k].iterations;
  }
  return {{"median_ms", statistics.quantile(0.5)},
          {"p99_ms", statistics.quantile(0.99)},
          {"phase_ms", phases(statistics.meanPhases())},
          {"iterations", iterations / static_cast<double>(count)}};
}

Json runBody(const Scene& scene, const StepCounts& counts) {
  const auto start = Clock::now();
  DeformableBody body(scene, loadMesh(scene));
  const double load_s = std::chrono::duration<double>(Clock::now() - start).count();
  const std::vector<StepResult> steps = take(&body, counts.warm_up + counts.measured);
  Json row = {{"elements", body.counts().elements}, {"dofs", body.counts().dofs}, {"load_s", load_s}};
  row.update(summary(steps, counts.warm_up, counts.measured));
  row["state_hash"] = std::to_string(body.stateHash());
  return row;
}

Json runCuts(const Scene& scene, const CutWindows& windows) {
  const auto start = Clock::now();
  DeformableBody body(scene, loadMesh(scene));
  const double load_s = std::chrono::duration<double>(Clock::now() - start).count();
  const int dofs_before = body.counts().dofs;
  const int to_last_cut = 1 + static_cast<int>(lastCutTime(scene) / scene.solver.time_step + 0.5);
  const std::vector<StepResult> steps =
      take(&body, to_last_cut + std::max(windows.after, windows.at_later + windows.later));
  requireApplied(steps);

  const BodyCounts counts = body.counts();
  const auto first = static_cast<std::size_t>(std::find_if(steps.begin(), steps.end(), cuts) - steps.begin());
  const auto after = static_cast<std::size_t>(to_last_cut);
  Json row = {{"elements", counts.elements}, {"crack_share", 100.0 * counts.crack_elements / counts.elements},
              {"dofs_before", dofs_before},  {"dofs", counts.dofs},
              {"pieces", counts.pieces},     {"load_s", load_s},
              {"first_ms", steps[0].step_ms}};
  row["before"] = summary(steps, first - windows.before, windows.before);
  const std::vector<StepResult> cutting = thoseThatCut(steps);
  row["cut"] = summary(cutting, 0, cutting.size());
  row["after"] = summary(steps, after, windows.after);
  for (std::size_t k = first - HITCH_BEFORE; k < std::min(steps.size(), first - HITCH_BEFORE + HITCH); ++k)
    row["hitch"].push_back(steps[k].step_ms);
  if (windows.later > 0) row["later"] = summary(steps, after + windows.at_later, windows.later);
  return row;
}

}  // namespace incision::bench
