// Whatever a description is, reading it gives an edge with two finite ends, jaws and scissors that are somewhere, and
// obstacles that are solid and somewhere, or an InputError.
#include <cmath>
#include <cstdint>
#include <cstdlib>
#include <string>

#include "incision/base/input_error.h"
#include "incision/contact/obstacles.h"
#include "incision/tool/blade/blade_edge.h"
#include "incision/tool/scissors/scissor_edges.h"

namespace {

using namespace incision;

void require(bool holds) {
  if (!holds) std::abort();
}

void readTool(const std::string& urdf) {
  ToolSettings tool;
  tool.link = "blade";
  const Edge edge = bladeEdge(tool, parseDescription(urdf, "tool.urdf"));
  require(edge[0].allFinite() && edge[1].allFinite() && edge[0] != edge[1]);
}

// The joint of the description that comes first, and its parent as the tool's link.
void readJaws(const std::string& urdf) {
  const Description description = parseDescription(urdf, "tool.urdf");
  if (description.joints.empty()) return;
  const DescribedJoint& joint = description.joints.front();
  const JawLinks links(description, description.links[static_cast<std::size_t>(joint.parent)].name, joint.name);
  for (int g = 0; g < links.groups(); ++g) require(links.pose(g, 0.1).position.allFinite());
  for (const ToolForm::GroupEdge& edge : scissorEdges(links, "tool.urdf").edges)
    require(edge.edge[0].allFinite() && edge.edge[1].allFinite() && edge.edge[0] != edge.edge[1]);
}

bool hasSize(const Solid& solid) { return solid.thickness() > 0 && std::isfinite(solid.reach()); }

bool isSomewhere(const Pose& pose) { return pose.position.allFinite() && std::abs(pose.orientation.norm() - 1) < 1e-9; }

void readObstacles(const std::string& urdf) {
  ContactSettings settings;
  settings.obstacles = "obstacles.urdf";
  const Obstacles obstacles = loadObstacles(settings, urdf, settings.obstacles);
  require(!obstacles.shapes.empty());
  for (const Obstacle& obstacle : obstacles.shapes) {
    require(hasSize(*obstacle.solid) && isSomewhere(obstacle.pose));
    require(isSomewhere(obstacles.links.at(static_cast<std::size_t>(obstacle.link)).pose));
  }
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const std::string urdf(reinterpret_cast<const char*>(data), size);
  for (const auto read : {readTool, readJaws, readObstacles}) {
    try {
      read(urdf);
    } catch (const InputError&) {
    }
  }
  return 0;
}
