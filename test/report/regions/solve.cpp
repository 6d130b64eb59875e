#include "report/regions/solve.h"

#include "incision/fem/boundary.h"
#include "incision/mesh/mesh_io.h"
#include "report/clock.h"
#include "report/mean_edge.h"
#include "report/temporary_folder.h"

namespace incision::report {

Solution solve(const TetMesh& mesh, RigSettings settings, int repeats, Method method) {
  settings.solver.method = method;
  settings.solver.threads = 2;
  Solution solution{};
  // Of a field on the boundary each node has a clamp of its own, which takes time that a clamp of a place does not.
  const std::vector<Clamp>& clamps = settings.conditions.clamps;
  if (clamps.size() > 1) solution.holding_ms = medianTime(repeats, [&] { heldNodes(mesh, clamps); });
  solution.ms = medianTime(repeats, [&] {
    Rig rig(mesh, settings);
    if (!rig.advance()) throw InputError("a body of several materials could not be solved");
    solution.energy = rig.step.assembly().elasticEnergy(rig.motion.x);
    solution.freedoms = 3 * static_cast<int>(rig.freeCopies().size());
    solution.iterations = rig.step.stats().iterations;
    solution.gave_up = rig.step.keep().fallback_steps > 0;
    solution.u.assign(mesh.nodes.size(), Vec3::Zero());
    const std::vector<Vec3> u = rig.displacements();
    for (int c = 0; c < rig.mesh.numCopies(); ++c) solution.u[rig.mesh.copyNode(c)] = u[c];
  });
  solution.ms -= solution.holding_ms;
  return solution;
}

nlohmann::json pointOf(const TetMesh& mesh, const Solution& solution) {
  return {{"edge", meanEdge(mesh, boundsOf(mesh))},
          {"elements", mesh.elements.size()},
          {"freedoms", solution.freedoms},
          {"ms", solution.ms},
          {"holding_ms", solution.holding_ms},
          {"iterations", solution.iterations},
          {"gave_up", solution.gave_up}};
}

TetMesh gmshMesh(const std::string& script, int cells) {
  const TemporaryFolder folder;
  folder.run("gmsh -3 -format msh22 -v 1 '" INCISION_SOURCE_DIR "/test/report/" + script + "' -setnumber cells " +
             std::to_string(cells) + " -o '" + folder.file("body.msh") + "'");
  return readGmsh(folder.file("body.msh"));
}

RegionSettings tissue(const Place& place, double young_modulus) {
  RegionSettings region;
  region.place = place;
  region.young_modulus = young_modulus;
  return region;
}

std::vector<Clamp> holdEach(const TetMesh& mesh, const std::function<bool(const Vec3&)>& chosen,
                            const std::function<Vec3(const Vec3&)>& field) {
  std::vector<Clamp> clamps;
  const Vec3 reach = Vec3::Constant(1e-9);
  for (const Vec3& X : mesh.nodes)
    if (chosen(X)) clamps.push_back({{X - reach, X + reach}, field(X)});
  return clamps;
}

bool isOnSurface(const RestBox& box, const Vec3& X) {
  return std::min((X - box.min).minCoeff(), (box.max - X).minCoeff()) < 1e-9;
}

}  // namespace incision::report
