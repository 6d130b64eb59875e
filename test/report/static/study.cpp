#include "report/static/study.h"

#include <cmath>
#include <map>

#include "report/clock.h"

namespace incision::report {
namespace {

using nlohmann::json;

double relativeError(const Quantity& quantity, double value) {
  return quantity.compliance ? quantity.answer / value - 1 : value / quantity.answer - 1;
}

struct MeshRun {
  TetMesh mesh;
  double edge, meshing_ms;
  int cells;
  std::vector<Solution> solutions;
};

/// Edge [m] of cells of six elements each, of the mean volume in a box.
double meanEdge(const TetMesh& mesh, const Box& box) {
  double volume = 0;
  int count = 0;
  for (std::size_t e = 0; e < mesh.elements.size(); ++e) {
    Vec3 centre = Vec3::Zero();
    for (int n : mesh.elements[e]) centre += mesh.nodes[n] / 4;
    if (!box.contains(centre)) continue;
    volume += elementVolume(mesh, static_cast<int>(e));
    ++count;
  }
  return std::cbrt(6 * volume / count);
}

MeshRun run(const Problem& problem, const Way& way, int cells, Gmsh* gmsh, int repeats) {
  MeshRun done;
  done.cells = cells;
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
  int iterations = 0;
  bool gave_up = false;
  for (int k : quantity.cases) {
    energies.push_back(at.solutions[k].energy);
    ms += at.solutions[k].ms;
    iterations += at.solutions[k].iterations;
    gave_up = gave_up || at.solutions[k].gave_up;
  }
  const double value = quantity.from(energies);
  json result = {{"cells", at.cells},
                 {"edge", at.edge},
                 {"elements", at.mesh.elements.size()},
                 {"freedoms", at.solutions[quantity.cases[0]].freedoms},
                 {"meshing_ms", at.meshing_ms},
                 {"ms", ms},
                 {"iterations", iterations},
                 {"gave_up", gave_up},
                 {"value", value},
                 {"error", relativeError(quantity, value)}};
  if (quantity.missing) result["missing_edges"] = quantity.missing(value) / at.edge;
  return result;
}

Curve curveOf(const json& points) {
  Curve curve;
  for (const json& p : points) {
    curve.edges.push_back(p["edge"]);
    curve.errors.push_back(p["error"]);
  }
  return curve;
}

json describe(const Way& way, const json& points, int order) {
  const Curve curve = curveOf(points);
  return {{"faces", way.faces},          {"unstructured", way.unstructured},
          {"longer", way.longer},        {"points", points},
          {"order", curve.order()},      {"expected_order", order},
          {"limit", curve.limit(order)}, {"constant", curve.constant(order)}};
}

/// Σ F² [N²] over the resultants of the loads.
double squaresOfResultants(const CutMesh& mesh, const std::vector<Load>& loads) {
  double sum = 0;
  for (const std::vector<Vec3>& forces : loadForces(mesh, loads)) {
    Vec3 resultant = Vec3::Zero();
    for (const Vec3& f : forces) resultant += f;
    sum += resultant.squaredNorm();
  }
  return sum;
}

}  // namespace

double Curve::order() const {
  const std::size_t last = errors.size() - 1, first = last - std::min<std::size_t>(last, 3);
  return std::log(std::abs(errors[first] / errors[last])) / std::log(edges[first] / edges[last]);
}

double Curve::limit(double order) const {
  const std::size_t first = errors.size() - std::min<std::size_t>(errors.size(), 4);
  const auto count = static_cast<double>(errors.size() - first);
  double x = 0, y = 0, xx = 0, xy = 0;
  for (std::size_t i = first; i < errors.size(); ++i) {
    const double size = std::pow(edges[i], order);
    x += size / count;
    y += errors[i] / count;
    xx += size * size / count;
    xy += size * errors[i] / count;
  }
  return y - x * (xy - x * y) / (xx - x * x);
}

double Curve::constant(double order) const { return std::abs(errors.back()) / std::pow(edges.back(), order); }

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

void study(const Problem& problem, Gmsh* gmsh, Findings* findings) {
  json quantities = json::array();
  for (const Quantity& quantity : problem.quantities)
    quantities.push_back({{"name", quantity.name}, {"unit", quantity.unit}, {"answer", quantity.answer}});
  const bool cut = static_cast<bool>(problem.cases[0].cut);
  bool as_meant = true;
  for (const Way& way : problem.ways) {
    std::vector<json> points(problem.quantities.size(), json::array());
    for (const int cells : problem.cells(way, findings->quick())) {
      const MeshRun done = run(problem, way, cells, gmsh, findings->quick() ? 1 : 3);
      for (const Solution& solution : done.solutions)
        as_meant = as_meant && (solution.parts_split > 0) == (cut && !way.faces);
      for (std::size_t q = 0; q < points.size(); ++q) {
        points[q].push_back(point(problem.quantities[q], done));
        std::printf("%s\n", (problem.name + ": " + way.name() + ": " + points[q].back().dump()).c_str());
      }
    }
    for (std::size_t q = 0; q < points.size(); ++q)
      quantities[q]["curves"].push_back(describe(way, points[q], problem.order));
  }
  if (cut) findings->claim(problem.name + ": a crack on faces splits no element, any other splits some", as_meant);
  findings->data()["problems"].push_back({{"name", problem.name}, {"quantities", quantities}});
}

}  // namespace incision::report
