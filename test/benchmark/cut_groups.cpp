#include <algorithm>
#include <cmath>
#include <iostream>

#include "benchmark/body_run.h"
#include "benchmark/child.h"
#include "benchmark/groups.h"
#include "benchmark/scenes.h"

namespace incision::bench {
namespace {

/// The windows of a run with cuts that a row may hold.
constexpr std::array<const char*, 4> WINDOWS = {"before", "cut", "after", "later"};

std::vector<Column> columns() {
  return {{"elements", "/elements"},
          {"% cut", "/crack_share", 1},
          {"freedoms", "/dofs_before"},
          {"then", "/dofs"},
          {"pieces", "/pieces"},
          {"before", "/before/median_ms", 2},
          {"cut", "/cut/median_ms", 2},
          {"dearest", "/cut/p99_ms", 2},
          {"after", "/after/median_ms", 2},
          {"later", "/later/median_ms", 2},
          {"x cut", "/times_before/cut", 2},
          {"x after", "/times_before/after", 2},
          {"x later", "/times_before/later", 2},
          {"it. before", "/before/iterations", 1},
          {"it. after", "/after/iterations", 1},
          {"MB", "/peak_mb", 0},
          {"kB/element", "/kb_per_element", 2}};
}

/// What the phases of the cut's step and of the steps after it took.
void printPhases(const Json& row) {
  for (const char* window : {"cut", "after"}) {
    const Json& phases = row[window]["phase_ms"];
    std::cout << "    " << window << ":";
    for (const auto& [phase, ms] : phases.items()) std::cout << "  " << phase << " " << ms.get<double>();
    std::cout << '\n';
  }
}

/// Each window as the round took it that was quickest there: other programs can only slow it down.
Json measureCuts(const std::string& name, const Scene& scene, const CutWindows& windows, int rounds) {
  Json best;
  for (int round = 0; round < rounds; ++round) {
    const Json row = inChild([&] { return runCuts(scene, windows); });
    if (round == 0) best = row;
    for (const char* window : WINDOWS)
      if (row.contains(window) && row[window]["median_ms"] < best[window]["median_ms"]) best[window] = row[window];
    for (std::size_t k = 0; k < best["hitch"].size(); ++k)
      best["hitch"][k] = std::min(best["hitch"][k].get<double>(), row["hitch"][k].get<double>());
  }
  Json row = {{"name", name}};
  row.update(best);
  for (const char* window : WINDOWS)
    if (row.contains(window))
      row["times_before"][window] = row[window]["median_ms"].get<double>() / row["before"]["median_ms"].get<double>();
  return row;
}

void report(const Table& table, Json row, const std::string& scene, Json* rows) {
  row["scene"] = scene;
  table.print(row);
  printPhases(row);
  rows->push_back(row);
}

}  // namespace

bool cuts(const Options& options, Json* rows) {
  const Table table(
      "A plane through at most 5 % of a bar's elements; wanted: cut 1.6, after 1.2 times before. Then no step iterates "
      "more than a quarter more often than those before the cut",
      columns());
  const int rounds = options.quick ? 1 : 5;
  for (const Cells& cells : {MIDDLE, BIG}) {
    Scene scene = cutBar(cells);
    const Json row = measureCuts(nameOf(cells), scene, {20, 20, 20, 100}, rounds);
    report(table, row, "cuts", rows);
    scene.solver.iterations = static_cast<int>(std::ceil(1.25 * row["before"]["iterations"].get<double>()));
    report(table,
           measureCuts(nameOf(cells) + ", iterations: " + std::to_string(*scene.solver.iterations), scene,
                       {20, 20, 20, 100}, rounds),
           "cuts", rows);
  }
  return true;
}

bool plate(const Options& options, Json* rows) {
  const Table table("A plate like the paper's figure 8 (4,671 to 7,026 freedoms), held at one edge, five crossing cuts",
                    columns());
  report(table, measureCuts("plate", cutPlate(), {40, options.quick ? 40 : 200, 0, 0}, options.quick ? 1 : 3), "plate",
         rows);
  return true;
}

bool organ(const Options& options, Json* rows) {
  const Table table("The organ at 5 ms a step, three cuts", columns());
  const Scene scene = cutOrgan();
  Json row = measureCuts("organ", scene, {40, options.quick ? 40 : 200, 0, 0}, options.quick ? 1 : 3);
  const double real_time = 1e3 * scene.solver.time_step / row["after"]["median_ms"].get<double>();
  row["real_time_factor"] = real_time;
  report(table, row, "organ", rows);
  std::cout << "    after the cuts it runs at " << real_time << " times real time (at least 3 wanted)\n";
  return true;
}

bool large(const Options&, Json* rows) {
  const Table table("A million elements", columns());
  const Json row = measureCuts(nameOf(HUGE_GRID), cutBar(HUGE_GRID), {10, 10, 0, 0}, 1);
  report(table, row, "large", rows);
  std::cout << "    loaded in " << row.at("load_s").get<double>()
            << " s; the first step, which finds the pattern, takes " << row.at("first_ms").get<double>() << " ms\n";
  return true;
}

}  // namespace incision::bench
