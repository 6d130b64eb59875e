#pragma once

#include <chrono>

#include "benchmark/body_run.h"

namespace incision::bench {

/// Takes steps of a body that another program simulates, as runBody does.
template <typename Peer>
Json runPeer(const Scene& scene, const StepCounts& counts) {
  const TetMesh mesh = loadMesh(scene);
  Peer peer(scene, mesh);
  std::vector<StepResult> steps(counts.warm_up + counts.measured);
  for (StepResult& step : steps) {
    const auto start = std::chrono::steady_clock::now();
    peer.step();
    step.step_ms = std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now() - start).count();
  }
  const Json times = summary(steps, counts.warm_up, counts.measured);
  return {{"elements", mesh.elements.size()},
          {"dofs", 3 * mesh.nodes.size()},
          {"median_ms", times["median_ms"]},
          {"p99_ms", times["p99_ms"]}};
}

}  // namespace incision::bench
