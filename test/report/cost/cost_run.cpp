#include "report/cost/cost_run.h"

#include <malloc.h>

#include <algorithm>
#include <chrono>
#include <cstdlib>
#include <stdexcept>

#include "support/allocation_hooks.h"

// Where valgrind is not installed, nothing runs under it.
#if __has_include(<valgrind/callgrind.h>)
#include <valgrind/callgrind.h>
#else
#define CALLGRIND_START_INSTRUMENTATION
#define CALLGRIND_STOP_INSTRUMENTATION
#endif

namespace incision::report {
namespace {

std::size_t heapInUse() {
  const struct mallinfo2 info = mallinfo2();
  return info.uordblks + info.hblkhd;
}

struct MeasuredSteps {
  explicit MeasuredSteps(int steps) {
    step_ms.reserve(steps);
    for (std::vector<int>* counts : {&iterations, &contacts, &cracks, &cuts}) counts->reserve(steps);
  }
  std::vector<double> step_ms;
  std::vector<int> iterations, contacts, cracks, cuts;
};

/// Apart, so that callgrind can be told to count in this function and what it calls.
[[gnu::noinline]] void takeMeasuredStep(DeformableBody& body, const Besides& besides, MeasuredSteps* measured) {
  const auto start = std::chrono::steady_clock::now();
  const StepResult step = body.step();
  if (besides.in_step) besides.in_step(body);
  const std::chrono::duration<double, std::milli> taken = std::chrono::steady_clock::now() - start;
  measured->step_ms.push_back(taken.count());
  measured->iterations.push_back(step.iterations);
  measured->contacts.push_back(step.contact.count);
  measured->cracks.push_back(static_cast<int>(step.cracks.size()));
  measured->cuts.push_back(static_cast<int>(step.cuts.size()));
}

}  // namespace

CostOptions costOptions(int argc, char** argv) {
  if (argc < 4) throw std::runtime_error("usage: " + std::string(argv[0]) + " SCENE.yaml FIRST STEPS [KEY=VALUE]...");
  return {argv[1], std::max(0, std::atoi(argv[2])), std::max(1, std::atoi(argv[3])), {argv + 4, argv + argc}};
}

nlohmann::json costOf(const CostOptions& options, const Besides& besides) {
  const Scene scene = loadScene(options.scene, options.overrides);
  const Descriptions descriptions = loadDescriptions(scene);
  MeasuredSteps measured(options.steps);

  const std::size_t before = heapInUse();
  DeformableBody body(scene, loadMesh(scene), descriptions);
  if (besides.set_up) besides.set_up(body);
  for (int k = 0; k < options.first; ++k) body.step();
  CALLGRIND_START_INSTRUMENTATION;
  const std::int64_t allocations = test::allocationsOf([&] {
    for (int k = 0; k < options.steps; ++k) {
      takeMeasuredStep(body, besides, &measured);
      if (besides.between) besides.between(body);
    }
  });
  CALLGRIND_STOP_INSTRUMENTATION;
  const std::size_t held = heapInUse() - before;

  const BodyCounts counts = body.counts();
  return {{"step_ms", measured.step_ms},
          {"iterations", measured.iterations},
          {"contacts", measured.contacts},
          {"cracks", measured.cracks},
          {"cuts", measured.cuts},
          {"allocations", static_cast<double>(allocations) / options.steps},
          {"bytes", held},
          {"elements", counts.elements},
          {"copies", counts.copies},
          {"pieces", counts.pieces}};
}

}  // namespace incision::report
