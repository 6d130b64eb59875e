#include "incision/tool/make_tool.h"

#include "incision/tool/blade/blade.h"
#include "incision/tool/blade/blade_edge.h"

namespace incision {
namespace {

std::unique_ptr<ToolContact> touchingShapes(const ToolSettings& settings, const Description& description,
                                            const std::optional<Edge>& edge, ContactSkin* skin) {
  if (!skin || settings.link.empty() || description.links.empty()) return nullptr;
  Obstacles shapes = loadLink(description, settings.link);
  if (shapes.shapes.empty()) return nullptr;
  return std::make_unique<ToolContact>(std::move(shapes), settings.friction, edge, skin);
}

}  // namespace

std::unique_ptr<Tool> makeTool(const ToolSettings& settings, const std::string& urdf,
                               const ToolSurroundings& surroundings) {
  Description description{settings.description, {}};
  if (!urdf.empty()) description = parseDescription(urdf, settings.description);
  const Edge edge = bladeEdge(settings, description);
  return std::make_unique<Blade>(settings, edge, tipFronts(edge, settings, description), surroundings.materials,
                                 surroundings.mesh, touchingShapes(settings, description, edge, surroundings.skin));
}

}  // namespace incision
