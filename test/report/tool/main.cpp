// Force on a blade and opening of its cut against its depth, with elements that are cut bit by bit or whole.
#include <algorithm>
#include <cmath>
#include <numeric>

#include "report/findings.h"
#include "report/tool/push.h"

namespace incision::report {
namespace {

using nlohmann::json;

constexpr double CUTTING_FORCE = 20;  // [N/m]
constexpr double PULL = 100;          // [Pa]
constexpr double STEADY = 0.02;       // depth from which the force is looked at: a cell of the coarse mesh [m]
constexpr int COARSE = 5, FINE = 9;   // cells over the height

/// How the force goes once the blade is in.
struct Steady {
  double mean = 0;    ///< [N]
  double ripple = 0;  ///< standard deviation over the mean
  double jump = 0;    ///< largest change in a step over the mean
  double work = 0;    ///< by what it cuts [J/m²]
};

Steady steadyOf(const Trace& trace) {
  const auto begin = std::upper_bound(trace.depth.begin(), trace.depth.end(), STEADY) - trace.depth.begin();
  const std::vector<double> force(trace.force.begin() + begin, trace.force.end());
  const auto count = static_cast<double>(force.size());
  Steady steady;
  steady.mean = std::accumulate(force.begin(), force.end(), 0.0) / count;
  for (const double f : force) steady.ripple += std::pow(f / steady.mean - 1, 2) / count;
  steady.ripple = std::sqrt(steady.ripple);
  for (std::size_t k = 1; k < force.size(); ++k)
    steady.jump = std::max(steady.jump, std::abs(force[k] - force[k - 1]) / steady.mean);
  steady.work = steady.mean * (trace.depth.back() - trace.depth[begin]) / (trace.area.back() - trace.area[begin]);
  return steady;
}

/// The largest before the blade has come to the face [N].
double forceBefore(const Trace& trace) {
  double largest = 0;
  for (std::size_t k = 0; trace.depth[k] <= 0; ++k) largest = std::max(largest, std::abs(trace.force[k]));
  return largest;
}

double largestStep(const std::vector<double>& values) {
  double largest = 0;
  for (std::size_t k = 1; k < values.size(); ++k) largest = std::max(largest, std::abs(values[k] - values[k - 1]));
  return largest;
}

double openingAt(const Trace& trace, double depth) {
  const auto k = std::lower_bound(trace.depth.begin(), trace.depth.end(), depth) - trace.depth.begin();
  const double share = (depth - trace.depth[k - 1]) / (trace.depth[k] - trace.depth[k - 1]);
  return (1 - share) * trace.opening[k - 1] + share * trace.opening[k];
}

/// What is asked of one mesh: with and without progressive opening.
struct Pair {
  Trace with, without;
};

Pair pushBoth(Push setting) {
  setting.progressive = true;
  Trace with = push(setting);
  setting.progressive = false;
  return {std::move(with), push(setting)};
}

/// The edge resists at eight points an element, so the share of the thickness that it acts on is known to this.
double resolutionOf(int cells) { return cellSize(cells) / 8 / BLOCK.z(); }

std::string nameOf(int cells) { return cells == COARSE ? "coarse mesh" : "fine mesh"; }

/// Returns the mean force with progressive opening.
double measureForce(Push setting, Findings* findings) {
  setting.cutting_force = CUTTING_FORCE;
  const Pair pair = pushBoth(setting);
  const Steady with = steadyOf(pair.with), without = steadyOf(pair.without);
  const double wanted = CUTTING_FORCE * BLOCK.z();
  const double resolution = resolutionOf(setting.cells);
  const std::string name = nameOf(setting.cells) + ": ";
  findings->claimBelow(name + "mean force against F_c × thickness, relative", std::abs(with.mean / wanted - 1),
                       resolution);
  findings->claimBelow(name + "work by area against F_c, relative", std::abs(with.work / CUTTING_FORCE - 1),
                       resolution);
  findings->claimBelow(name + "force before the blade is at the face, by the mean", forceBefore(pair.with) / with.mean,
                       0.01);
  findings->claimBelow(name + "ripple of the force, progressive by whole", with.ripple / without.ripple, 0.25);
  findings->claimBelow(name + "largest change of the force in a step, progressive by whole", with.jump / without.jump,
                       0.25);
  const auto entry = [](const Trace& trace, const Steady& steady) -> json {
    return {{"depth", trace.depth},    {"force", trace.force}, {"mean", steady.mean},
            {"ripple", steady.ripple}, {"jump", steady.jump},  {"work", steady.work}};
  };
  findings->data()["force"].push_back({{"cells", setting.cells},
                                       {"resolution", resolution},
                                       {"with", entry(pair.with, with)},
                                       {"without", entry(pair.without, without)}});
  return with.mean;
}

/// Openings of blocks cut by rectangles of one cell, two, ... up to a depth.
json openingsAtRest(int cells, double depth) {
  json points = json::array();
  for (int k = 0; k * cellSize(cells) < depth + 1e-9; ++k)
    points.push_back({k * cellSize(cells), openingAtRest(cells, PULL, k * cellSize(cells))});
  return points;
}

void measureOpening(Push setting, Findings* findings) {
  setting.pull = PULL;
  const Pair pair = pushBoth(setting);
  const json rest = openingsAtRest(setting.cells, setting.depth);
  double worst = 0;
  for (const json& point : rest)
    worst = std::max(worst, std::abs(openingAt(pair.with, point[0]) / point[1].get<double>() - 1));
  const double with = largestStep(pair.with.opening), without = largestStep(pair.without.opening);
  const std::string name = nameOf(setting.cells) + ": ";
  findings->claimBelow(name + "opening where the blade ends a cell, against that of a block cut to there, relative",
                       worst, 0.02);
  findings->claimBelow(name + "largest change of the opening in a step, progressive by whole", with / without, 0.85);
  const auto entry = [](const Trace& trace, double jump) -> json {
    return {{"depth", trace.depth}, {"opening", trace.opening}, {"jump", jump}};
  };
  findings->data()["opening"].push_back({{"cells", setting.cells},
                                         {"rest", rest},
                                         {"off", worst},
                                         {"with", entry(pair.with, with)},
                                         {"without", entry(pair.without, without)}});
}

void measure(Findings* findings) {
  Push setting;
  if (findings->quick()) setting.depth = 0.06, setting.stride = 1e-3;
  std::vector<double> forces;
  for (const int cells : {COARSE, FINE}) {
    setting.cells = cells;
    forces.push_back(measureForce(setting, findings));
    measureOpening(setting, findings);
  }
  findings->claimBelow("mean force, coarse against fine mesh, relative", std::abs(forces[0] / forces[1] - 1),
                       resolutionOf(COARSE));
  const int finest = findings->quick() ? 11 : 15;
  json& data = findings->data();
  data["reference"] = {{"cells", finest}, {"points", openingsAtRest(finest, setting.depth)}};
  data["cutting_force"] = CUTTING_FORCE;
  data["young_modulus"] = YOUNG_MODULUS;
  data["block"] = {BLOCK.x(), BLOCK.y(), BLOCK.z()};
  data["pull"] = PULL;
  data["steady"] = STEADY;
  data["stride"] = setting.stride;
}

}  // namespace
}  // namespace incision::report

int main(int argc, char** argv) {
  incision::report::Findings findings(argc, argv);
  incision::report::measure(&findings);
  return findings.write();
}
