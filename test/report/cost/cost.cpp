#include <malloc.h>

#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "incision/body/deformable_body.h"
#include "incision/mesh/input_error.h"
#include "support/allocation_count.h"

namespace incision::report {
namespace {

constexpr const char* USAGE = R"(usage: report_cost SCENE.yaml FIRST STEPS [KEY=VALUE]...

Takes FIRST steps of a scene, then STEPS that are measured, and prints what these cost as one line of JSON.
)";

std::size_t heapInUse() {
  const struct mallinfo2 info = mallinfo2();
  return info.uordblks + info.hblkhd;
}

/// Of the measured steps.
struct Cost {
  std::vector<double> step_ms;
  std::vector<int> iterations, contacts, cracks, cuts;
};

Cost withRoomFor(int steps) {
  Cost cost;
  cost.step_ms.reserve(steps);
  for (std::vector<int>* counts : {&cost.iterations, &cost.contacts, &cost.cracks, &cost.cuts}) counts->reserve(steps);
  return cost;
}

/// Apart, so that callgrind can be told to count in this function alone.
[[gnu::noinline]] void takeMeasuredSteps(DeformableBody& body, int steps, Cost* cost) {
  for (int k = 0; k < steps; ++k) {
    const StepResult step = body.step();
    cost->step_ms.push_back(step.step_ms);
    cost->iterations.push_back(step.iterations);
    cost->contacts.push_back(step.contact.count);
    cost->cracks.push_back(static_cast<int>(step.cracks.size()));
    cost->cuts.push_back(static_cast<int>(step.cuts.size()));
  }
}

void measure(const std::string& path, int first, int steps, const std::vector<std::string>& overrides) {
  const Scene scene = loadScene(path, overrides);
  const Descriptions descriptions{loadDescription(scene), loadObstacleDescription(scene)};
  Cost cost = withRoomFor(steps);

  const std::size_t before = heapInUse();
  DeformableBody body(scene, loadMesh(scene), descriptions);
  for (int k = 0; k < first; ++k) body.step();
  const std::int64_t allocations = test::allocationsOf([&] { takeMeasuredSteps(body, steps, &cost); });
  const std::size_t held = heapInUse() - before;

  const BodyCounts counts = body.counts();
  const nlohmann::json all = {{"step_ms", cost.step_ms},
                              {"iterations", cost.iterations},
                              {"contacts", cost.contacts},
                              {"cracks", cost.cracks},
                              {"cuts", cost.cuts},
                              {"allocations", static_cast<double>(allocations) / steps},
                              {"bytes", held},
                              {"elements", counts.elements},
                              {"copies", counts.copies},
                              {"pieces", counts.pieces}};
  std::printf("%s\n", all.dump().c_str());
}

}  // namespace
}  // namespace incision::report

int main(int argc, char** argv) {
  if (argc < 4) {
    std::fputs(incision::report::USAGE, stderr);
    return 2;
  }
  try {
    incision::report::measure(argv[1], std::max(0, std::atoi(argv[2])), std::max(1, std::atoi(argv[3])),
                              {argv + 4, argv + argc});
  } catch (const std::exception& error) {
    std::fprintf(stderr, "report_cost: %s\n", error.what());
    return 1;
  }
}
