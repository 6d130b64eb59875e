#include "incision/tool/blade/blade_edge.h"

#include <algorithm>

#include "incision/base/input_error.h"
#include "incision/rigid/description.h"

namespace incision {

namespace {

Edge checkedEdge(const Edge& edge, const std::string& where) {
  if (!edge[0].allFinite() || !edge[1].allFinite() || !((edge[1] - edge[0]).norm() > 0)) {
    throw InputError(where + ": the blade's edge (allowed: two different points with finite coordinates)");
  }
  return edge;
}

// Along the box's longest axis (of equal ones the first), where the other two coordinates are smallest.
Edge longestEdge(const DescribedShape& box, const std::string& where) {
  checkShape(box, where);
  int axis = 0;
  box.shape.size.maxCoeff(&axis);
  const Vec3 begin = -box.shape.size / 2;
  Vec3 end = begin;
  end[axis] = -begin[axis];
  return checkedEdge(placed({begin, end}, box.pose), where);
}

}  // namespace

Edge bladeEdge(const ToolSettings& tool, const std::string& urdf, const std::string& name) {
  if (tool.edge) return checkedEdge(*tool.edge, name);
  const std::vector<DescribedLink> links = parseDescription(urdf, name);
  const DescribedLink& link = findLink(links, tool.link, name);
  const std::string where = linkInMessage(name, tool.link);
  const auto box = std::find_if(link.shapes.begin(), link.shapes.end(),
                                [](const auto& s) { return !s.is_mesh && s.shape.kind == ShapeKind::BOX; });
  if (box != link.shapes.end()) return longestEdge(*box, where);
  throw InputError(where + (link.fault.empty() ? " has no collision box to take the edge from" : ": " + link.fault));
}

}  // namespace incision
