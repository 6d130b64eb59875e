// A bar bent to a circle, ν = 0: u = κ (−x z, 0, x²/2) is exact, so that the error has norms.
#include <cmath>

#include "report/clock.h"
#include "report/field_distance.h"
#include "report/static/study.h"

namespace incision::report {
namespace {

constexpr double E = 1e6, L = 1, H = 0.2, CURVATURE = 1e-3;  // [Pa], [m], [1/m]

Vec3 exactField(const Vec3& X) {
  const double z = X.z() - H / 2;
  return CURVATURE * Vec3(-X.x() * z, 0, X.x() * X.x() / 2);
}

/// Holds the ends; the nodes at x = L go where the field takes them in the one step of a second.
RigSettings bentEnds(const TetMesh& mesh) {
  RigSettings settings = statics(E, 0);
  settings.solver.method = Method::AUTO;
  settings.solver.threads = 2;
  settings.conditions.clamps = {{slab(0, 0), Vec3::Zero()}};
  const Vec3 reach = Vec3::Constant(1e-9);
  for (const Vec3& X : mesh.nodes)
    if (slab(0, L).contains(X)) settings.conditions.clamps.push_back({{X - reach, X + reach}, exactField(X)});
  return settings;
}

nlohmann::json point(const TetMesh& mesh, int cells, int repeats) {
  const double exact_energy = 0.5 * E * CURVATURE * CURVATURE * std::pow(H, 4) / 12 * L;
  nlohmann::json result = {{"cells", cells},
                           {"edge", std::cbrt(6 * L * H * H / static_cast<double>(mesh.elements.size()))},
                           {"elements", mesh.elements.size()}};
  const RigSettings settings = bentEnds(mesh);
  result["ms"] = medianTime(repeats, [&] {
    Rig rig(mesh, settings);
    if (!rig.advance()) throw InputError("the bent bar could not be solved");
    result["freedoms"] = 3 * rig.mesh.numCopies();
    result["displacement"] = distanceFrom(exactField, mesh, rig.displacements());
    // The ends have the exact displacements: ‖u_h − u‖² = ‖u_h‖² − ‖u‖² in the energy norm.
    result["energy"] = std::sqrt(rig.step.assembly().elasticEnergy(rig.motion.x) / exact_energy - 1);
  });
  return result;
}

}  // namespace

nlohmann::json studyBending(Gmsh* gmsh, bool quick) {
  nlohmann::json kinds;
  for (const bool unstructured : {false, true}) {
    nlohmann::json points;
    for (const int n : quick ? std::vector<int>{4, 6, 8, 12} : std::vector<int>{4, 6, 8, 12, 16}) {
      const TetMesh mesh = unstructured ? gmsh->mesh("bar.geo", n, true).mesh : block({5 * n, n, n}, Vec3(L, H, H));
      points.push_back(point(mesh, n, quick ? 1 : 3));
    }
    kinds.push_back({{"unstructured", unstructured}, {"points", points}});
  }
  return kinds;
}

}  // namespace incision::report
