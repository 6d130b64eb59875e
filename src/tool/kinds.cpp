#include "incision/tool/kinds.h"

#include "incision/tool/blade/blade.h"
#include "incision/tool/grasper/grasper.h"
#include "incision/tool/probe/probe.h"
#include "incision/tool/scissors/scissors.h"

namespace incision {
namespace {

/// A kind's own parser as that of any kind.
template <auto parse>
KindSettings parsed(const YamlMap& tool) {
  return parse(tool);
}

}  // namespace

const std::vector<ToolKind>& toolKinds() {
  static const std::vector<ToolKind> kinds = {
      {"blade",
       {"edge", "cutting_force", "cutting_viscosity", "cutting_onset", "progressive"},
       false,
       false,
       parsed<parseBlade>,
       makeBlade},
      {"grasper", {"closed", "grip"}, true, true, parsed<parseGrasper>, makeGrasper},
      {"probe", {}, false, true, [](const YamlMap&) { return KindSettings(ProbeSettings()); }, makeProbe},
      {"scissors",
       {"cutting_force", "cutting_viscosity", "cutting_onset", "progressive"},
       true,
       true,
       parsed<parseScissors>,
       makeScissors},
  };
  static_assert(std::variant_size_v<KindSettings> == 4, "each alternative has a line above");
  return kinds;
}

Touching linkTouching(const ToolSettings& settings, const Description& description, const std::optional<Edge>& edge,
                      ContactSkin* skin) {
  Touching touching;
  if (!skin || settings.link.empty() || description.links.empty()) return touching;
  Obstacles shapes = loadLink(description, settings.link);
  if (!shapes.shapes.empty())
    touching.push_back(std::make_unique<ToolContact>(0, std::move(shapes), settings.friction, edge, skin));
  return touching;
}

std::unique_ptr<Tool> makeTool(const ToolSettings& settings, const std::string& urdf,
                               const ToolSurroundings& surroundings) {
  Description description;
  description.name = settings.description;
  if (!urdf.empty()) description = parseDescription(urdf, settings.description);
  return kindOf(settings).make(settings, description, surroundings);
}

}  // namespace incision
