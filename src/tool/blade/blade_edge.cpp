#include "incision/tool/blade/blade_edge.h"

#include <cmath>

#include "incision/base/input_error.h"

namespace incision {

namespace {

Edge checkedEdge(const Edge& edge, const std::string& where) {
  if (!edge[0].allFinite() || !edge[1].allFinite() || !((edge[1] - edge[0]).norm() > 0)) {
    throw InputError(where + ": the blade's edge (allowed: two different points with finite coordinates)");
  }
  return edge;
}

}  // namespace

Edge bladeEdge(const ToolSettings& tool, const Description& description) {
  if (const auto& edge = std::get<BladeSettings>(tool.kind).edge) return checkedEdge(*edge, description.name);
  const DescribedLink& link = description.link(tool.link);
  const std::string where = linkInMessage(description.name, tool.link);
  for (const DescribedSolid& described : link.solids) {
    if (!described.solid || !described.solid->edge()) continue;
    checkSolid(described, where);
    return checkedEdge(placed(*described.solid->edge(), described.pose), where);
  }
  throw InputError(where + (link.fault.empty() ? " has no collision box to take the edge from" : ": " + link.fault));
}

std::array<double, 2> tipFronts(const Edge& edge, const ToolSettings& tool, const Description& description) {
  std::array<double, 2> fronts = {0, 0};
  if (tool.link.empty() || description.links.empty()) return fronts;
  for (const DescribedSolid& described : description.link(tool.link).solids) {
    if (!described.solid) continue;
    const double thickness = described.solid->thickness();
    for (int end = 0; end < 2; ++end) {
      const Vec3 at = described.pose.orientation.conjugate() * (edge[end] - described.pose.position);
      const bool belongs = std::abs(described.solid->distanceTo(at).distance) <= thickness;
      if (belongs && (fronts[end] == 0 || thickness < fronts[end])) fronts[end] = thickness;
    }
  }
  return fronts;
}

}  // namespace incision
