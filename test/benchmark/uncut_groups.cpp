#include <algorithm>
#include <iostream>
#include <sstream>

#include "benchmark/bullet_body.h"
#include "benchmark/groups.h"
#include "benchmark/peer_run.h"
#include "benchmark/plain_reference.h"
#include "benchmark/rounds.h"
#include "benchmark/scenes.h"

namespace incision::bench {
namespace {

/// For what takes seconds a step.
constexpr StepCounts FEW = {5, 5};

constexpr int ROUNDS = 3;

StepCounts full(const Options& options) { return options.quick ? StepCounts{5, 40} : StepCounts{20, 200}; }
int rounds(const Options& options) { return options.quick ? 1 : ROUNDS; }

std::vector<Column> columns() {
  return {{"elements", "/elements"},
          {"freedoms", "/dofs"},
          {"median", "/median_ms", 2},
          {"99 %", "/p99_ms", 2},
          {"ns/element", "/ns_per_element"},
          {"x auto", "/times_auto", 2},
          {"assembly", "/phase_ms/assembly", 2},
          {"solve", "/phase_ms/solve", 2},
          {"update", "/phase_ms/update", 2},
          {"iterations", "/iterations", 1},
          {"MB", "/peak_mb", 0},
          {"kB/element", "/kb_per_element", 2}};
}

Run ourRun(const std::string& name, Scene scene, Method method, const StepCounts& counts) {
  scene.solver.method = method;
  return {name, [=] { return runBody(scene, counts); }};
}

/// The runs on one bar; the first is ours with method auto.
std::vector<Run> gridRuns(const Options& options, const Cells& cells, double young_modulus) {
  const Scene scene = bar(cells, young_modulus);
  const StepCounts counts = full(options);
  const bool slow = cells == BIG;
  std::vector<Run> runs = {ourRun("auto", scene, Method::AUTO, counts),
                           ourRun("iterative", scene, Method::ITERATIVE, counts)};
  if (slow && options.quick) return runs;
  runs.push_back(ourRun("direct", scene, Method::DIRECT, slow ? FEW : counts));
  runs.back().slow = slow;
  if (young_modulus > 1e6) return runs;
  const StepCounts peer_counts = slow ? FEW : StepCounts{20, 40};
  runs.push_back({"plain CHOLMOD", [=] { return runPeer<PlainReference>(scene, peer_counts); }, slow});
  runs.push_back({"Bullet", [=] { return runPeer<BulletBody>(scene, peer_counts); }, slow});
  return runs;
}

/// How `auto` stands against the better of the two methods.
void compareMethods(const std::vector<Json>& bests) {
  const auto median = [&](std::size_t run) { return bests[run]["median_ms"].get<double>(); };
  const double better = bests.size() > 2 ? std::min(median(1), median(2)) : median(1);
  std::cout << "    auto takes " << median(0) / better << " times the better of the methods (at most 1.1 allowed)\n";
}

void measureGrid(const Options& options, const Cells& cells, double young_modulus, const Table& table, Json* rows) {
  std::ostringstream scene;
  scene << nameOf(cells) << ", E = " << young_modulus;
  const std::vector<Json> bests = bestOfRounds(gridRuns(options, cells, young_modulus), rounds(options));
  for (Json row : bests) {
    row["scene"] = "grids";
    row["grid"] = nameOf(cells);
    row["young_modulus"] = young_modulus;
    row["program"] = row["name"];
    row["name"] = scene.str() + ", " + row["name"].get<std::string>();
    row["ns_per_element"] = 1e6 * row["median_ms"].get<double>() / row["elements"].get<double>();
    row["times_auto"] = row["median_ms"].get<double>() / bests[0]["median_ms"].get<double>();
    table.print(row);
    rows->push_back(row);
  }
  compareMethods(bests);
}

}  // namespace

bool grids(const Options& options, Json* rows) {
  const Table table("Bars that swing, two threads; peers on the soft ones", columns());
  for (double young_modulus : {1e6, 1e8})
    for (const Cells& cells : {SMALL, MIDDLE, BIG}) measureGrid(options, cells, young_modulus, table, rows);
  return true;
}

bool threads(const Options& options, Json* rows) {
  const Table table("Bar " + nameOf(BIG) + " on one to eight threads", columns());
  const StepCounts counts = options.quick ? StepCounts{5, 10} : StepCounts{20, 60};
  std::vector<Run> runs;
  for (int count : {1, 2, 4, 8}) {
    Scene scene = bar(BIG);
    scene.solver.threads = count;
    runs.push_back(ourRun(std::to_string(count) + (count > 1 ? " threads" : " thread"), scene, Method::AUTO, counts));
  }
  const std::vector<Json> bests = bestOfRounds(runs, rounds(options));
  bool equal = true;
  for (Json row : bests) {
    row["scene"] = "threads";
    table.print(row);
    rows->push_back(row);
    equal = equal && row["state_hash"] == bests[0]["state_hash"];
  }
  std::cout << "    two threads are " << bests[0]["median_ms"].get<double>() / bests[1]["median_ms"].get<double>()
            << " times as fast as one (at least 1.5 wanted); the states are " << (equal ? "equal" : "NOT EQUAL")
            << '\n';
  return equal;
}

bool sizes(const Options& options, Json* rows) {
  const Table table("The bar in elements ever smaller", columns());
  std::vector<Cells> sizes = {{14, 4, 3}, SMALL, {23, 6, 6}, MIDDLE, {46, 12, 12}, BIG};
  if (!options.quick) sizes.push_back({93, 23, 23});
  if (options.large) sizes.insert(sizes.end(), {HUGE_GRID, {200, 50, 50}});
  for (const Cells& cells : sizes) {
    const bool slow = cells[0] > BIG[0];
    Json row = bestOfRounds({ourRun(nameOf(cells), bar(cells), Method::AUTO, slow ? StepCounts{5, 10} : full(options))},
                            slow ? 1 : rounds(options))[0];
    row["scene"] = "sizes";
    row["ns_per_element"] = 1e6 * row["median_ms"].get<double>() / row["elements"].get<double>();
    table.print(row);
    rows->push_back(row);
  }
  return true;
}

bool linear(const Options& options, Json* rows) {
  const Table table("Bar " + nameOf(MIDDLE) + " without warping", columns());
  Scene scene = bar(MIDDLE);
  scene.body.warping = false;
  for (Json row : bestOfRounds({ourRun("warping: false, auto", scene, Method::AUTO, full(options)),
                                ourRun("warping: false, direct", scene, Method::DIRECT, full(options))},
                               rounds(options))) {
    row["scene"] = "linear";
    table.print(row);
    rows->push_back(row);
  }
  return true;
}

}  // namespace incision::bench
