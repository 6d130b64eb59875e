// Error against time of moving bars: integrator, step, solver, tolerance, mass, warping, mesh.
#include <algorithm>
#include <cmath>

#include "report/clock.h"
#include "report/dynamic/bars.h"
#include "report/dynamic/oscillation.h"
#include "report/findings.h"

namespace incision::report {
namespace {

using nlohmann::json;

// Cells across of the bars whose time steps are compared, and of the reference whose mesh is.
constexpr int CELLS = 3;

struct Effort {
  std::vector<double> time_steps;  ///< [s], descending
  double reference_step;           ///< [s]
  int rounds;                      ///< of which the median time counts
};

/// One curve.
struct Variant {
  std::string name;
  Scheme scheme;
  Choice choice;
};

Effort effortOf(bool quick) {
  if (quick) return {{0.02, 0.01, 0.005, 0.0025}, 1.0 / 1600, 1};
  return {{0.05, 0.02, 0.01, 0.005, 0.0025, 0.00125}, 1.0 / 6400, 5};
}

/// Solved so exactly that only the step is left.
Run referenceOf(const Bar& bar, const Scheme& scheme, double time_step) {
  return simulate(bar, scheme, {CELLS, time_step, Method::ITERATIVE, 1e-9, Mass::LUMPED, true});
}

json point(const Choice& choice, const Run& run, double error) {
  return {{"time_step", choice.time_step},
          {"error", std::isfinite(error) ? json(error) : json()},
          {"ms", run.ms},
          {"iterations", run.iterations},
          {"energy_growth", std::isfinite(run.energy_growth) ? json(run.energy_growth) : json()}};
}

/// The error over the steps, a curve for each variant. Each round runs all, so that what disturbs the machine for a
/// while disturbs all alike.
json curvesOf(const Bar& bar, const Run& reference, const std::vector<Variant>& variants, const Effort& effort) {
  const std::size_t steps = effort.time_steps.size();
  std::vector<std::vector<double>> ms(variants.size() * steps);
  json curves = json::array();
  for (int round = 0; round < effort.rounds; ++round)
    for (std::size_t v = 0; v < variants.size(); ++v) {
      if (round == 0) curves.push_back({{"name", variants[v].name}, {"points", json::array()}});
      for (std::size_t k = 0; k < steps; ++k) {
        Choice choice = variants[v].choice;
        choice.time_step = effort.time_steps[k];
        const Run run = simulate(bar, variants[v].scheme, choice);
        ms[v * steps + k].push_back(run.ms);
        if (round == 0)
          curves[v]["points"].push_back(point(choice, run, errorAgainst(reference, CELLS, run, CELLS, CELLS)));
      }
    }
  for (std::size_t v = 0; v < variants.size(); ++v)
    for (std::size_t k = 0; k < steps; ++k) curves[v]["points"][k]["ms"] = median(ms[v * steps + k]);
  return curves;
}

double errorAt(const json& curve, double time_step) {
  for (const json& at : curve["points"])
    if (at["time_step"] == time_step && !at["error"].is_null()) return at["error"];
  return std::numeric_limits<double>::infinity();
}

/// Of the two smallest steps.
double orderOf(const json& curve) {
  const json& points = curve["points"];
  const json &coarse = points[points.size() - 2], &fine = points[points.size() - 1];
  return std::log(coarse["error"].get<double>() / fine["error"].get<double>()) /
         std::log(coarse["time_step"].get<double>() / fine["time_step"].get<double>());
}

/// One problem, a curve for each integrator.
json integrators(const Bar& bar, const Effort& effort, Findings* findings) {
  const Run reference = referenceOf(bar, sdirk2Scheme(), effort.reference_step);
  const Run other = referenceOf(bar, bdf2Scheme(), effort.reference_step);
  std::vector<Variant> variants;
  for (const Scheme& scheme : allSchemes()) variants.push_back({scheme.name, scheme, Choice()});
  const json curves = curvesOf(bar, reference, variants, effort);
  const json &euler = curves[0], &bdf2 = curves[1], &newton = curves[2];
  double growth = 0;
  for (const json& at : bdf2["points"])
    if (at["time_step"] <= 0.02) growth = std::max(growth, at["energy_growth"].get<double>());
  if (bar.gravity == 0)
    findings->claimBelow("BDF2, " + bar.name + " bar, dt up to 20 ms: energy gained, as a share", growth, 1e-3);
  if (bar.name == "swinging" && bar.young_modulus == 1e6) {
    findings->claimAbove("Swinging bar, dt = 5 ms: error of Euler over that of BDF2",
                         errorAt(euler, 0.005) / errorAt(bdf2, 0.005), 5);
    findings->claimAbove("Swinging bar, dt = 5 ms: error with two Newton iterations over that with one",
                         errorAt(newton, 0.005) / errorAt(euler, 0.005), 0.95);
    findings->claimAbove("Swinging bar: order of Euler", orderOf(euler), 0.8);
  }
  if (bar.name == "spinning" && bar.young_modulus == 1e6)
    findings->claimAbove("Spinning bar: order of BDF2", orderOf(bdf2), 1.8);
  return {{"name", bar.name},
          {"young_modulus", bar.young_modulus},
          {"references_differ", errorAgainst(reference, CELLS, other, CELLS, CELLS)},
          {"curves", curves}};
}

/// One problem and integrator, a curve for each solver and tolerance.
json solvers(const Bar& bar, const Scheme& scheme, const Effort& effort, Findings* findings) {
  const Run reference = referenceOf(bar, sdirk2Scheme(), effort.reference_step);
  Choice choice;
  choice.method = Method::DIRECT;
  std::vector<Variant> variants = {{"direct", scheme, choice}};
  choice.method = Method::ITERATIVE;
  for (const double tolerance : {1e-2, 1e-4, 1e-6}) {
    choice.tolerance = tolerance;
    char name[32];
    std::snprintf(name, sizeof name, "iterative, %.0e", tolerance);
    variants.push_back({name, scheme, choice});
  }
  const json curves = curvesOf(bar, reference, variants, effort);
  double worst = 0;
  for (const double time_step : effort.time_steps)
    worst = std::max(worst, std::abs(errorAt(curves[2], time_step) / errorAt(curves[0], time_step) - 1));
  findings->claimBelow(scheme.name + ", " + bar.name + " bar: error at a tolerance of 1e-4 against direct, relative",
                       worst, 0.05);
  return {{"name", bar.name}, {"scheme", scheme.name}, {"curves", curves}};
}

/// Error of mesh and step together, against a finer mesh: a curve for each kind of mass, and one without warping.
json meshes(const Bar& bar, bool quick) {
  constexpr double TIME_STEP = 0.0025;
  const int finest = quick ? 8 : 16, coarsest = 2;
  const Scheme scheme = bdf2Scheme();
  const Run reference = simulate(bar, scheme, {finest, TIME_STEP, Method::ITERATIVE, 1e-6, Mass::LUMPED, true});
  json curves = json::array();
  const auto add = [&](const std::string& name, Mass mass, bool warping) {
    json points = json::array();
    for (int cells = coarsest; cells < finest; cells *= 2) {
      const Choice choice = {cells, TIME_STEP, Method::AUTO, 1e-4, mass, warping};
      const Run run = simulate(bar, scheme, choice);
      json at = point(choice, run, errorAgainst(reference, finest, run, cells, coarsest));
      at["cells"] = cells;
      points.push_back(at);
    }
    curves.push_back({{"name", name}, {"points", points}});
  };
  add("lumped mass", Mass::LUMPED, true);
  add("consistent mass", Mass::CONSISTENT, true);
  add("without warping", Mass::LUMPED, false);
  return {{"name", bar.name}, {"finest", finest}, {"time_step", TIME_STEP}, {"curves", curves}};
}

void measure(Findings* findings) {
  const Effort effort = effortOf(findings->quick());
  json& data = findings->data();
  data["cells"] = CELLS;
  data["reference_step"] = effort.reference_step;
  data["oscillation"] = freeOscillation(findings);
  std::vector<Bar> bars = {swingingBar(1e6), spinningBar(1e6)};
  if (!findings->quick()) bars.insert(bars.end(), {twistingBar(), swingingBar(1e7), spinningBar(1e8)});
  for (const Bar& bar : bars) data["integrators"].push_back(integrators(bar, effort, findings));
  data["solvers"].push_back(solvers(swingingBar(1e6), eulerScheme(), effort, findings));
  data["solvers"].push_back(solvers(swingingBar(1e6), bdf2Scheme(), effort, findings));
  data["meshes"].push_back(meshes(swingingBar(1e6), findings->quick()));
}

}  // namespace
}  // namespace incision::report

int main(int argc, char** argv) {
  incision::report::Findings findings(argc, argv);
  incision::report::measure(&findings);
  return findings.write();
}
