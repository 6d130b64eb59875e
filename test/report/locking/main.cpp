#include <algorithm>
#include <cmath>
#include <cstdio>
#include <exception>
#include <map>

#include "report/findings.h"
#include "report/locking/nodal.h"
#include "report/locking/reference.h"
#include "report/locking/specimen.h"

namespace incision::report {
namespace {

using Json = nlohmann::json;

/// Tissue that is as incompressible as a scene may be.
constexpr double NEARLY_HALF = 0.4999;
/// What a scene may have instead: the default, and as much as a remedy bears well.
constexpr double CAPPED = 0.45, MODERATE = 0.49;

const char* nameOf(Pressure pressure) { return pressure == Pressure::ELEMENT ? "plain" : "averaged"; }

class Locking {
 public:
  Locking(int argc, char** argv) : findings_(argc, argv) {}

  int run() {
    findReferences();
    errorsByRatio();
    solversByRatio();
    for (const Problem& problem : {cantilever(), pressedBlock()})
      for (double ratio : {CAPPED, MODERATE, NEARLY_HALF}) errorsByTime(problem, ratio);
    cutBeam();
    cutBentBeam();
    findings_.data()["capped"] = CAPPED;
    findings_.data()["moderate"] = MODERATE;
    return findings_.write();
  }

 private:
  std::vector<double> ratios() const {
    return findings_.quick() ? std::vector<double>{0.3, CAPPED, MODERATE, NEARLY_HALF}
                             : std::vector<double>{0.3, 0.4, CAPPED, MODERATE, 0.499, NEARLY_HALF};
  }
  int middleGrid() const { return findings_.quick() ? 2 : 4; }
  std::vector<int> grids() const {
    return findings_.quick() ? std::vector<int>{1, 2, 3} : std::vector<int>{1, 2, 3, 4, 6};
  }

  void findReferences();
  void errorsByRatio();
  void solversByRatio();
  void errorsByTime(const Problem& problem, double ratio);
  void cutBeam();
  void cutBentBeam();
  double error(const Problem& problem, double ratio, double answer) const {
    return answer / references_.at({problem.name, ratio}) - 1;
  }

  Findings findings_;
  std::map<std::pair<std::string, double>, double> references_;
};

void Locking::findReferences() {
  for (const Problem& problem : {cantilever(), halfCantilever(), heldBlock(), pressedBlock()}) {
    const bool beam = problem.axis == 0;
    const int cells = (findings_.quick() ? 16 : 24) * (beam ? 2 : 1);
    for (double ratio : ratios()) references_[{problem.name, ratio}] = reference(problem, ratio, cells);
    const double coarse = reference(problem, NEARLY_HALF, 2 * cells / 3);
    Json& known = findings_.data()["references"][problem.name];
    known["change"] = coarse / references_[{problem.name, NEARLY_HALF}] - 1;
    for (double ratio : ratios()) known["answers"].push_back(references_[{problem.name, ratio}]);
  }
}

/// Errors against ν, all on one size of mesh.
void Locking::errorsByRatio() {
  double locked = HUGE_VAL, on_grids = 0, on_others = 0, capped = 0;
  for (const Problem& problem : {cantilever(), heldBlock(), pressedBlock()}) {
    const TetMesh grid = problem.grid(middleGrid()), other = problem.unstructured(middleGrid());
    Json of = {{"problem", problem.name},
               {"plate", problem.plate()},
               {"elements", grid.elements.size()},
               {"unstructured elements", other.elements.size()}};
    for (double ratio : ratios()) {
      of["ratios"].push_back(ratio);
      const auto add = [&](const char* kind, double answer) {
        of[kind].push_back(error(problem, ratio, answer));
        return std::abs(error(problem, ratio, answer));
      };
      const double plain = add("plain", Specimen(problem, grid, ratio, Pressure::ELEMENT).answer());
      const double averaged = add("averaged", Specimen(problem, grid, ratio, Pressure::AVERAGED).answer());
      const double plain_other = add("plain unstructured", Specimen(problem, other, ratio, Pressure::ELEMENT).answer());
      const double averaged_other =
          add("averaged unstructured", Specimen(problem, other, ratio, Pressure::AVERAGED).answer());
      if (ratio != NEARLY_HALF) continue;
      locked = std::min({locked, plain, plain_other});
      on_grids = std::max(on_grids, averaged);
      on_others = std::max(on_others, averaged_other);
    }
    const auto modelError = [&](double used) {
      return error(problem, NEARLY_HALF, references_.at({problem.name, used}));
    };
    of["model"] = {{"capped", modelError(CAPPED)}, {"moderate", modelError(MODERATE)}};
    if (problem.axis == 0) capped = std::abs(modelError(CAPPED));
    findings_.data()["errors"].push_back(of);
  }
  findings_.claimAbove("plain elements, ν = 0.4999: least error of three problems on two meshes", locked, 0.5);
  findings_.claimBelow("averaged pressure, ν = 0.4999: largest error on grids", on_grids, 0.2);
  findings_.claimBelow("averaged pressure, ν = 0.4999: largest error on unstructured meshes", on_others, 0.5);
  findings_.claimBelow("ν = 0.45 instead of 0.4999 in a bent beam, by CalculiX", capped, 0.02);
}

/// What a step takes of either solver, against ν.
void Locking::solversByRatio() {
  const Problem problem = cantilever();
  const TetMesh mesh = problem.grid(middleGrid());
  double worst = 0;
  for (double ratio : ratios()) {
    Json at = {{"ratio", ratio}};
    for (Pressure pressure : {Pressure::ELEMENT, Pressure::AVERAGED}) {
      const StepCost iterative = stepCost(problem, mesh, ratio, pressure, Method::ITERATIVE, 20);
      const StepCost direct = stepCost(problem, mesh, ratio, pressure, Method::DIRECT, 10);
      at[nameOf(pressure)] = {
          {"iterations", iterative.iterations}, {"iterative", iterative.milliseconds}, {"direct", direct.milliseconds}};
    }
    worst = std::max(worst, at["averaged"]["iterations"].get<double>() / at["plain"]["iterations"].get<double>());
    findings_.data()["solvers"]["steps"].push_back(at);
  }
  const auto blocks = [&](Pressure pressure) { return Specimen(problem, mesh, 0.3, pressure).blocks(); };
  const double wider = static_cast<double>(blocks(Pressure::AVERAGED)) / blocks(Pressure::ELEMENT);
  findings_.data()["solvers"]["elements"] = mesh.elements.size();
  findings_.data()["solvers"]["blocks"] = wider;
  findings_.claimBelow("averaged pressure: iterations by those of plain elements, at the worst ν", worst, 1.1);
  findings_.claimBelow("averaged pressure: entries of the matrix by those of plain elements, grid", wider, 2);
}

/// Error at rest against the time of a step, over finer and finer grids.
void Locking::errorsByTime(const Problem& problem, double ratio) {
  Json of = {{"problem", problem.name}, {"ratio", ratio}};
  for (int refinement : grids()) {
    const TetMesh mesh = problem.grid(refinement);
    const auto add = [&](const char* kind, double used, Pressure pressure) {
      const int steps = refinement > 2 ? 5 : 20;
      const StepCost cost = stepCost(problem, mesh, used, pressure, Method::ITERATIVE, steps);
      of[kind].push_back({{"elements", mesh.elements.size()},
                          {"error", error(problem, ratio, Specimen(problem, mesh, used, pressure).answer())},
                          {"ms", cost.milliseconds},
                          {"iterations", cost.iterations}});
    };
    add("plain", ratio, Pressure::ELEMENT);
    if (ratio > CAPPED) add("capped", CAPPED, Pressure::ELEMENT);
    add("averaged", ratio, Pressure::AVERAGED);
    if (ratio > MODERATE) add("moderate", MODERATE, Pressure::AVERAGED);
    if (refinement > 4) continue;
    const NodalAverage nodal = nodalAverage(problem, mesh, ratio);
    const Specimen averaged(problem, mesh, ratio, Pressure::AVERAGED);
    of["nodal"].push_back({{"error", error(problem, ratio, nodal.answer)},
                           {"blocks", static_cast<double>(nodal.blocks) / averaged.blocks()},
                           {"elements", mesh.elements.size()}});
  }
  findings_.data()["times"].push_back(of);
}

/// A cantilever that a plane through the middle of its elements splits into two of half the depth.
void Locking::cutBeam() {
  Problem problem = cantilever();
  double worst = 0;
  for (int refinement : findings_.quick() ? std::vector<int>{2} : std::vector<int>{2, 4}) {
    problem.cells = {8 * refinement, 2 * refinement, 2 * refinement + 1};
    double compressible = 0;
    for (double ratio : ratios()) {
      Json at = {{"ratio", ratio}, {"layers", refinement + 0.5}};
      for (Pressure pressure : {Pressure::ELEMENT, Pressure::AVERAGED}) {
        const Specimen split(problem, problem.grid(1), ratio, pressure, {plane(Vec3(0, 0, 0.125), Vec3::UnitZ())});
        at[nameOf(pressure)] = error(halfCantilever(), ratio, split.answer());
      }
      const double averaged = at["averaged"];
      if (ratio == ratios().front()) compressible = averaged;
      worst = std::max(worst, averaged / compressible);
      findings_.data()["cut"].push_back(at);
    }
  }
  findings_.claimBelow("averaged pressure: error of a beam split within its elements, at the worst ν by ν = 0.3", worst,
                       1.2);
}

/// What a cut does that takes a bent beam apart.
void Locking::cutBentBeam() {
  const Problem problem = cantilever();
  const TetMesh mesh = problem.grid(middleGrid());
  const PlaneCut cut = plane(Vec3(0.52, 0, 0), Vec3(1, 0.1, 0.05));
  double added = 0;
  for (double ratio : ratios()) {
    Json at = {{"ratio", ratio}};
    for (Pressure pressure : {Pressure::ELEMENT, Pressure::AVERAGED}) {
      const CutEffect effect = cutUnderLoad(problem, mesh, ratio, pressure, cut);
      at[nameOf(pressure)] = {{"added", effect.added}, {"kinetic", effect.kinetic}};
      if (ratio == MODERATE && pressure == Pressure::AVERAGED) added = effect.added;
    }
    findings_.data()["jump"].push_back(at);
  }
  findings_.claimBelow("averaged pressure, ν = 0.49: elastic energy that a cut through a bent beam adds, as a share",
                       added, 0.05);
}

}  // namespace
}  // namespace incision::report

int main(int argc, char** argv) {
  try {
    return incision::report::Locking(argc, argv).run();
  } catch (const std::exception& error) {
    std::fprintf(stderr, "%s\n", error.what());
    return 1;
  }
}
