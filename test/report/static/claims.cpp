// What every machine must find, with room for other versions of Gmsh; the worst of each group of curves.
#include <algorithm>
#include <array>
#include <cmath>

#include "report/static/study.h"

namespace incision::report {
namespace {

using nlohmann::json;

/// Bounds for a group of curves: grids are alike everywhere, Gmsh's meshes vary.
struct Bounds {
  std::string name;
  int expected_order;
  bool unstructured;
  double order, limit, inside_over_faces;
};

const std::array<Bounds, 4> GROUPS = {{{"beams on grids", 2, false, 1.9, 0.01, 1.05},
                                       {"beams on Gmsh's meshes", 2, true, 1.7, 0.04, 1.2},
                                       {"cracks that end, on grids", 1, false, 0.75, 0.15, 1.7},
                                       {"cracks that end, on Gmsh's meshes", 1, true, 0.5, 0.15, 3.5}}};

void claimGroup(const Bounds& group, const json& problems, Findings* findings) {
  double order = 10, limit = 0, inside_over_faces = 0;
  for (const json& problem : problems)
    for (const json& quantity : problem["quantities"]) {
      double inside = 0, on_faces = 1;
      for (const json& curve : quantity["curves"]) {
        if (curve["expected_order"] != group.expected_order || curve["unstructured"] != group.unstructured ||
            curve["longer"])
          continue;
        order = std::min(order, curve["order"].get<double>());
        limit = std::max(limit, std::abs(curve["limit"].get<double>()));
        (curve["faces"] ? on_faces : inside) = curve["constant"];
      }
      inside_over_faces = std::max(inside_over_faces, inside / on_faces);
    }
  findings->claimAbove(group.name + ": least order of convergence", order, group.order);
  findings->claimBelow(group.name + ": largest relative error extrapolated to edge 0", limit, group.limit);
  findings->claimBelow(group.name + ": error of a crack inside elements over that on faces, equal edge",
                       inside_over_faces, group.inside_over_faces);
}

/// The most edges by which a crack acts as if it were shorter, on the finest meshes.
double mostMissing(const json& problems, bool faces) {
  double most = 0;
  for (const json& problem : problems)
    for (const json& quantity : problem["quantities"])
      for (const json& curve : quantity["curves"]) {
        const json& fine = curve["points"].back();
        if (curve["faces"] == faces && !curve["longer"] && fine.contains("missing_edges"))
          most = std::max(most, fine["missing_edges"].get<double>());
      }
  return most;
}

/// The largest error, on the finest meshes of a kind, of the figures of cracks that end inside elements, as they are or
/// made longer.
double largestError(const json& problems, bool unstructured, bool longer) {
  double largest = 0;
  for (const json& problem : problems)
    for (const json& quantity : problem["quantities"])
      for (const json& curve : quantity["curves"])
        if (curve["expected_order"] == 1 && curve["unstructured"] == unstructured && !curve["faces"] &&
            curve["longer"] == longer)
          largest = std::max(largest, std::abs(curve["points"].back()["error"].get<double>()));
  return largest;
}

}  // namespace

void claimConvergence(Findings* findings) {
  const json problems = findings->data()["problems"];
  for (const Bounds& group : GROUPS) claimGroup(group, problems, findings);
  const json& whole = problems[0]["quantities"][0]["curves"][0]["points"].back();
  findings->claimBelow("cantilever: relative error on the finest grid", whole["error"], 0.03);
  for (const bool unstructured : {false, true})
    findings->claimBelow(std::string("cracks inside elements of ") + (unstructured ? "Gmsh's meshes" : "grids") +
                             ": largest error once made longer, over that before, finest mesh",
                         largestError(problems, unstructured, true) / largestError(problems, unstructured, false), 0.5);
  findings->claimBelow("a crack on faces acts as if shorter by, in edges", mostMissing(problems, true), 0.8);
  findings->claimBelow("a crack inside elements acts as if shorter by, in edges", mostMissing(problems, false), 1);
}

}  // namespace incision::report
