// Rigid zones: whether they move as they are told, and nothing else with them.
#include "report/benchmark/exact.h"

#include <algorithm>
#include <limits>

#include "incision/cut/point.h"

namespace incision::report {
namespace {

using nlohmann::json;

/// How far the corners of parts are from where `moved` says that the part goes, at worst [m].
template <typename Moved>
double largestError(const Rig& rig, const Moved& moved) {
  const std::vector<Vec3> u = rig.displacements();
  double worst = 0;
  for (int p = 0; p < static_cast<int>(rig.mesh.parts().size()); ++p) {
    const Vec3 answer = moved(p);
    for (const Barycentric& corner : rig.mesh.polytope(p).corners)
      worst = std::max(worst, (at(rig.mesh.parts()[p], corner, u) - answer).norm());
  }
  return worst;
}

json entry(const char* problem, const char* published, const Rig& rig, double size, double moved, double error) {
  return {{"problem", problem},
          {"published", published},
          {"elements", rig.mesh.mesh().elements.size()},
          {"pieces", rig.pieces()},
          {"error", error / moved},
          {"roundings", error / (std::numeric_limits<double>::epsilon() * size)}};
}

json moveZones(const ZonesCase& of) {
  RigSettings settings = statics(205e9, 0.3);
  double farthest = 0;
  for (const Zone& zone : of.zones) {
    settings.conditions.clamps.push_back({zone.clamp, zone.moved / settings.solver.time_step});
    farthest = std::max(farthest, zone.moved.norm());
  }
  Rig rig(of.mesh, settings);
  for (const PlaneCut& cut : of.cuts) rig.cut(cut);
  if (!rig.advance()) throw InputError(std::string(of.problem) + ": could not be solved");
  const auto moved = [&](int p) {
    const Vec3 centre = atRest(rig.mesh, rig.mesh.parts()[p].element, rig.mesh.centroid(p));
    return std::find_if(of.zones.begin(), of.zones.end(), [&](const Zone& zone) { return zone.box.contains(centre); })
        ->moved;
  };
  json found = entry(of.problem, of.published, rig, of.size, farthest, largestError(rig, moved));
  found["zones"] = of.zones.size();
  return found;
}

/// Cracks all in one element, the pieces of which set off with velocities of their own.
json throwPieces(const char* problem, const char* published, int zones, const std::vector<PlaneCut>& cuts) {
  Rig rig({{Vec3::Zero(), Vec3::UnitX(), Vec3::UnitY(), Vec3::UnitZ()}, {{0, 1, 2, 3}}}, {});
  for (const PlaneCut& cut : cuts) rig.cut(cut);
  const std::vector<Vec3> velocity = randomVectors(rig.pieces(), 1, 1);  // [m/s]
  int count = 0;
  const std::vector<int> piece = rig.mesh.copyPieces(&count);
  for (std::size_t c = 0; c < piece.size(); ++c) rig.motion.v[c] = velocity[piece[c]];
  if (!rig.advance()) throw InputError(std::string(problem) + ": could not be solved");
  const auto moved = [&](int p) -> Vec3 { return rig.time_step * velocity[piece[rig.mesh.parts()[p].copies[0]]]; };
  json found = entry(problem, published, rig, 1, rig.time_step * largest(velocity), largestError(rig, moved));
  found["zones"] = zones;
  return found;
}

}  // namespace

json rigidZones() {
  json found;
  for (const ZonesCase& of : publishedZones()) found.push_back(moveZones(of));
  const auto across = [](double x) { return plane(Vec3(x, 0.2, 0.2), Vec3::UnitX()); };
  const auto level = [](double z) { return plane(Vec3(0.2, 0.2, z), Vec3::UnitZ()); };
  const auto branch = [](double z) { return rectangle(Vec3(0.7, 0.2, z), Vec3::UnitZ(), Vec3::UnitX(), 1, 0); };
  found.push_back(throwPieces("X within one element", "SSNV511", 4, {across(0.2), level(0.2)}));
  found.push_back(
      throwPieces("I within one element", "SSNV512", 4,
                  {level(0.2), level(0.45), rectangle(Vec3(0.2, 0.2, 0.325), Vec3::UnitX(), Vec3::UnitZ(), 0.25, 0)}));
  found.push_back(throwPieces("F within one element", "SSNV513", 4, {across(0.2), branch(0.15), branch(0.35)}));
  return found;
}

}  // namespace incision::report
