// Answers in nearly incompressible tissue, by plain elements and by averaged pressure; measure.py makes errors of them.
#include "report/locking/nodal.h"
#include "report/locking/specimen.h"
#include "report/section.h"

namespace incision::report {
namespace {

using Json = nlohmann::json;

/// Tissue that is as incompressible as a scene may be.
constexpr double NEARLY_HALF = 0.4999;
/// What a scene may have instead: the default, and as much as a remedy bears well.
constexpr double CAPPED = 0.45, MODERATE = 0.49;

constexpr Pressure PRESSURES[] = {Pressure::ELEMENT, Pressure::AVERAGED};
const char* nameOf(Pressure pressure) { return pressure == Pressure::ELEMENT ? "plain" : "averaged"; }

/// Answers against ν, all on one size of mesh.
Json answersByRatio(const std::vector<double>& ratios, int refinement) {
  Json found;
  for (const Problem& problem : {cantilever(), heldBlock(), pressedBlock()}) {
    const TetMesh grid = problem.grid(refinement), other = problem.unstructured(refinement);
    Json of = {{"problem", problem.name}, {"elements", grid.elements.size()}, {"ratios", ratios}};
    for (double ratio : ratios)
      for (Pressure pressure : PRESSURES) {
        const std::string kind = nameOf(pressure);
        of[kind].push_back(Specimen(problem, grid, ratio, pressure).answer());
        of[kind + " unstructured"].push_back(Specimen(problem, other, ratio, pressure).answer());
      }
    found.push_back(of);
  }
  return found;
}

/// What a step takes of either solver, against ν.
Json solversByRatio(const std::vector<double>& ratios, int refinement) {
  const Problem problem = cantilever();
  const TetMesh mesh = problem.grid(refinement);
  Json steps;
  for (double ratio : ratios) {
    Json at = {{"ratio", ratio}};
    for (Pressure pressure : PRESSURES) {
      const StepCost iterative = stepCost(problem, mesh, ratio, pressure, Method::ITERATIVE, 20);
      const StepCost direct = stepCost(problem, mesh, ratio, pressure, Method::DIRECT, 10);
      at[nameOf(pressure)] = {
          {"iterations", iterative.iterations}, {"iterative", iterative.milliseconds}, {"direct", direct.milliseconds}};
    }
    steps.push_back(at);
  }
  const auto blocks = [&](Pressure pressure) { return Specimen(problem, mesh, 0.3, pressure).blocks(); };
  return {{"steps", steps},
          {"elements", mesh.elements.size()},
          {"blocks", static_cast<double>(blocks(Pressure::AVERAGED)) / blocks(Pressure::ELEMENT)}};
}

/// Answers at rest and the time of a step, over finer and finer grids.
Json answersByTime(const Problem& problem, double ratio, const std::vector<int>& refinements) {
  Json of = {{"problem", problem.name}, {"ratio", ratio}};
  for (int refinement : refinements) {
    const TetMesh mesh = problem.grid(refinement);
    const auto add = [&](const char* kind, double used, Pressure pressure) {
      const int steps = refinement > 2 ? 5 : 20;
      const StepCost cost = stepCost(problem, mesh, used, pressure, Method::ITERATIVE, steps);
      of[kind].push_back({{"answer", Specimen(problem, mesh, used, pressure).answer()}, {"ms", cost.milliseconds}});
    };
    add("plain", ratio, Pressure::ELEMENT);
    if (ratio > CAPPED) add("capped", CAPPED, Pressure::ELEMENT);
    add("averaged", ratio, Pressure::AVERAGED);
    if (ratio > MODERATE) add("moderate", MODERATE, Pressure::AVERAGED);
    if (refinement > 4) continue;
    const NodalAverage nodal = nodalAverage(problem, mesh, ratio);
    const Specimen averaged(problem, mesh, ratio, Pressure::AVERAGED);
    of["nodal"].push_back({{"answer", nodal.answer},
                           {"blocks", static_cast<double>(nodal.blocks) / averaged.blocks()},
                           {"elements", mesh.elements.size()}});
  }
  return of;
}

/// A cantilever that a plane through the middle of its elements splits into two of half the depth.
Json cutBeam(const std::vector<double>& ratios, const std::vector<int>& refinements) {
  Problem problem = cantilever();
  Json found;
  for (int refinement : refinements) {
    problem.cells = {8 * refinement, 2 * refinement, 2 * refinement + 1};
    for (double ratio : ratios) {
      Json at = {{"ratio", ratio}, {"layers", refinement + 0.5}};
      for (Pressure pressure : PRESSURES) {
        const Specimen split(problem, problem.grid(1), ratio, pressure, {plane(Vec3(0, 0, 0.125), Vec3::UnitZ())});
        at[nameOf(pressure)] = split.answer();
      }
      found.push_back(at);
    }
  }
  return found;
}

/// What a cut does that takes a bent beam apart.
Json cutBentBeam(const std::vector<double>& ratios, int refinement) {
  const Problem problem = cantilever();
  const TetMesh mesh = problem.grid(refinement);
  const PlaneCut cut = plane(Vec3(0.52, 0, 0), Vec3(1, 0.1, 0.05));
  Json found;
  for (double ratio : ratios) {
    Json at = {{"ratio", ratio}};
    for (Pressure pressure : PRESSURES) {
      const CutEffect effect = cutUnderLoad(problem, mesh, ratio, pressure, cut);
      at[nameOf(pressure)] = {{"added", effect.added}, {"kinetic", effect.kinetic}};
    }
    found.push_back(at);
  }
  return found;
}

void measure(bool quick, Json* data) {
  using Ints = std::vector<int>;
  std::vector<double> ratios = {0.3, CAPPED, MODERATE, NEARLY_HALF};
  if (!quick) ratios = {0.3, 0.4, CAPPED, MODERATE, 0.499, NEARLY_HALF};
  const int refinement = quick ? 2 : 4;
  (*data)["capped"] = CAPPED;
  (*data)["moderate"] = MODERATE;
  (*data)["errors"] = answersByRatio(ratios, refinement);
  (*data)["solvers"] = solversByRatio(ratios, refinement);
  for (const Problem& problem : {cantilever(), pressedBlock()})
    for (double ratio : {CAPPED, MODERATE, NEARLY_HALF})
      (*data)["times"].push_back(answersByTime(problem, ratio, quick ? Ints{1, 2, 3} : Ints{1, 2, 3, 4, 6}));
  (*data)["cut"] = cutBeam(ratios, quick ? Ints{2} : Ints{2, 4});
  (*data)["jump"] = cutBentBeam(ratios, refinement);
}

}  // namespace
}  // namespace incision::report

int main(int argc, char** argv) { return incision::report::writeSection(argc, argv, incision::report::measure); }
