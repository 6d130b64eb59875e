#include "report/static/study.h"

#include <cmath>
#include <map>

#include "report/clock.h"
#include "report/mean_edge.h"
#include "support/loads.h"

namespace incision::report {
namespace {

using nlohmann::json;

double relativeError(const Quantity& quantity, double value) {
  return quantity.compliance ? quantity.answer / value - 1 : value / quantity.answer - 1;
}

struct MeshRun {
  TetMesh mesh;
  double edge, meshing_ms;
  std::vector<Solution> solutions;
};

MeshRun run(const Problem& problem, const Way& way, int cells, Gmsh* gmsh, int repeats) {
  MeshRun done;
  if (way.unstructured) {
    const Gmsh::Made& made = gmsh->mesh(problem.geometry, cells, way.faces);
    done.mesh = made.mesh;
    done.meshing_ms = made.ms;
  } else {
    const Clock clock;
    done.mesh = problem.grid(cells, way.faces);
    done.meshing_ms = clock.ms();
  }
  done.edge = meanEdge(done.mesh, problem.fine);
  for (const Case& c : problem.cases)
    done.solutions.push_back(solve(done.mesh, c, way.longer ? MISSING_EDGES * done.edge : 0, repeats));
  return done;
}

json point(const Quantity& quantity, const MeshRun& at) {
  std::vector<double> energies;
  double ms = 0;
  bool gave_up = false;
  json parts_split;
  for (int k : quantity.cases) {
    const Solution& solution = at.solutions[k];
    energies.push_back(solution.energy);
    ms += solution.ms;
    gave_up = gave_up || solution.gave_up;
    parts_split.push_back(solution.parts_split);
  }
  const double value = quantity.from(energies);
  json result = {{"edge", at.edge},
                 {"freedoms", at.solutions[quantity.cases[0]].freedoms},
                 {"meshing_ms", at.meshing_ms},
                 {"ms", ms},
                 {"gave_up", gave_up},
                 {"parts_split", parts_split},
                 {"error", relativeError(quantity, value)}};
  if (quantity.missing) result["missing_edges"] = quantity.missing(value) / at.edge;
  return result;
}

/// Σ F² [N²] over the resultants of the loads.
double squaresOfResultants(const CutMesh& mesh, const std::vector<Load>& loads) {
  double sum = 0;
  for (const Load& load : loads) {
    Vec3 resultant = Vec3::Zero();
    for (const Vec3& f : loadForces(mesh, load)) resultant += f;
    sum += resultant.squaredNorm();
  }
  return sum;
}

}  // namespace

Solution solve(const TetMesh& mesh, const Case& problem, double longer, int repeats, Method method) {
  RigSettings settings = problem.settings;
  settings.solver.method = method;
  settings.solver.threads = 2;
  Solution solution{};
  solution.ms = medianTime(repeats, [&] {
    Rig rig(mesh, settings);
    if (problem.cut) solution.parts_split = problem.cut(&rig, longer).parts_split;
    if (!rig.advance()) throw InputError("a static problem could not be solved");
    solution.energy = rig.step.assembly().elasticEnergy(rig.motion.x);
    if (problem.load_squares > 0)
      solution.energy *= problem.load_squares / squaresOfResultants(rig.mesh, settings.conditions.loads);
    solution.freedoms = 3 * rig.mesh.numCopies();
    solution.iterations = rig.step.stats().iterations;
    solution.gave_up = solution.iterations > 0 && rig.step.stats().residual < 1e-3 * settings.solver.tolerance;
  });
  return solution;
}

json study(const Problem& problem, Gmsh* gmsh, bool quick) {
  json quantities;
  for (const Quantity& quantity : problem.quantities) quantities.push_back({{"name", quantity.name}});
  for (const Way& way : problem.ways) {
    std::vector<json> points(problem.quantities.size());
    for (const int cells : problem.cells(way, quick)) {
      const MeshRun done = run(problem, way, cells, gmsh, quick ? 1 : 3);
      for (std::size_t q = 0; q < points.size(); ++q) points[q].push_back(point(problem.quantities[q], done));
    }
    for (std::size_t q = 0; q < points.size(); ++q)
      quantities[q]["curves"].push_back({{"faces", way.faces},
                                         {"unstructured", way.unstructured},
                                         {"longer", way.longer},
                                         {"expected_order", problem.order},
                                         {"points", points[q]}});
  }
  return {{"name", problem.name}, {"quantities", quantities}};
}

}  // namespace incision::report
