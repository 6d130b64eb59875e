// Error against time of moving bars: integrator, step, solver, tolerance, mass, warping, mesh.
#include <cmath>

#include "report/clock.h"
#include "report/dynamic/bars.h"
#include "report/dynamic/oscillation.h"
#include "report/section.h"

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

/// Where a bar goes: one that is free by a scheme that shares nothing with those that are compared, in steps that no
/// wave outruns.
Run truth(const Bar& bar, const Effort& effort) {
  if (bar.clamped) return referenceOf(bar, sdirk2Scheme(), effort.reference_step);
  return referenceOf(bar, verletScheme(), 2e-4 * std::sqrt(1e6 / bar.young_modulus));
}

/// One problem, a curve for each integrator.
json integrators(const Bar& bar, const Effort& effort) {
  const Run reference = truth(bar, effort);
  const Run other = referenceOf(bar, bdf2Scheme(), effort.reference_step);
  std::vector<Variant> variants;
  for (const Scheme& scheme : schemesOf(bar.clamped)) variants.push_back({scheme.name, scheme, Choice()});
  return {{"name", bar.name},
          {"young_modulus", bar.young_modulus},
          {"references_differ", errorAgainst(reference, CELLS, other, CELLS, CELLS)},
          {"curves", curvesOf(bar, reference, variants, effort)}};
}

/// One problem and integrator, a curve for each solver and tolerance.
json solvers(const Bar& bar, const Scheme& scheme, const Effort& effort) {
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
  return {{"scheme", scheme.name}, {"curves", curvesOf(bar, reference, variants, effort)}};
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
  return {{"finest", finest}, {"time_step", TIME_STEP}, {"curves", curves}};
}

void measure(bool quick, json* data) {
  const Effort effort = effortOf(quick);
  (*data)["cells"] = CELLS;
  (*data)["reference_step"] = effort.reference_step;
  (*data)["oscillation"] = freeOscillation();
  std::vector<Bar> bars = {swingingBar(1e6), spinningBar(1e6)};
  if (!quick) bars.insert(bars.end(), {twistingBar(), swingingBar(1e7), spinningBar(1e8)});
  for (const Bar& bar : bars) (*data)["integrators"].push_back(integrators(bar, effort));
  for (const Scheme& scheme : {eulerScheme(), bdf2Scheme()})
    (*data)["solvers"].push_back(solvers(swingingBar(1e6), scheme, effort));
  (*data)["meshes"].push_back(meshes(swingingBar(1e6), quick));
}

}  // namespace
}  // namespace incision::report

int main(int argc, char** argv) { return incision::report::writeSection(argc, argv, incision::report::measure); }
