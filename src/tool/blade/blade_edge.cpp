#include "incision/tool/blade/blade_edge.h"

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
  if (tool.edge) return checkedEdge(*tool.edge, description.name);
  const DescribedLink& link = description.link(tool.link);
  const std::string where = linkInMessage(description.name, tool.link);
  for (const DescribedSolid& described : link.solids) {
    if (!described.solid || !described.solid->edge()) continue;
    checkSolid(described, where);
    return checkedEdge(placed(*described.solid->edge(), described.pose), where);
  }
  throw InputError(where + (link.fault.empty() ? " has no collision box to take the edge from" : ": " + link.fault));
}

}  // namespace incision
