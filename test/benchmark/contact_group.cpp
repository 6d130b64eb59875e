#include <iostream>

#include "benchmark/body_run.h"
#include "benchmark/groups.h"
#include "benchmark/rounds.h"
#include "benchmark/scenes.h"

namespace incision::bench {
namespace {

/// Bars and walls of as many elements each.
constexpr std::array<std::pair<Cells, Cells>, 2> SIZES = {{{SMALL, {8, 4, 8}}, {MIDDLE, {16, 8, 16}}}};

/// Until all lies still [steps]: after 150 the pieces of the larger wall still rock on each other.
constexpr int SETTLING = 1000;

std::vector<Column> columns() {
  return {{"elements", "/elements"},
          {"freedoms", "/dofs"},
          {"median", "/median_ms", 2},
          {"x bar", "/times_bar", 2},
          {"contact", "/phase_ms/contact", 2},
          {"ns/element", "/contact_ns", 1},
          {"assembly", "/phase_ms/assembly", 2},
          {"solve", "/phase_ms/solve", 2},
          {"iterations", "/iterations", 1}};
}

}  // namespace

bool contact(const Options& options, Json* rows) {
  const Table table(
      "A wall in one piece and in eight, at rest on the ground; wanted: 1.4 times the swinging bar's step", columns());
  const StepCounts counts = {SETTLING, options.quick ? 40 : 200};
  for (const auto& [bar_cells, wall_cells] : SIZES) {
    const Scene swinging = bar(bar_cells), whole = wall(wall_cells, false), pieces = wall(wall_cells, true);
    const std::vector<Run> runs = {{"bar, no contact", [&] { return runBody(swinging, counts); }},
                                   {"wall, whole", [&] { return runBody(whole, counts); }},
                                   {"wall, eight pieces", [&] { return runBody(pieces, counts); }}};
    const std::vector<Json> bests = bestOfRounds(runs, options.quick ? 1 : 3);
    for (Json row : bests) {
      row["scene"] = "contact";
      row["times_bar"] = row["median_ms"].get<double>() / bests[0]["median_ms"].get<double>();
      row["contact_ns"] = 1e6 * row["phase_ms"]["contact"].get<double>() / row["elements"].get<double>();
      table.print(row);
      rows->push_back(row);
    }
  }
  return true;
}

}  // namespace incision::bench
