#include "incision/tool/jawed_tool.h"

#include <utility>

namespace incision {
namespace {

Obstacles shapesOf(const JawLinks& links, int group) {
  Obstacles obstacles;
  obstacles.links.push_back({links.name(group), Pose()});
  for (const DescribedSolid& described : links.solids(group))
    obstacles.shapes.push_back({described.solid, described.pose, 0});
  return obstacles;
}

}  // namespace

JawedTool::JawedTool(const ToolSettings& settings, JawLinks links, Touching touching)
    : Tool(settings, std::move(touching)), links_(std::move(links)) {}

ToolForm JawedTool::form() const {
  ToolForm form = Tool::form();
  form.shapes = Obstacles();
  for (int g = 0; g < groups(); ++g) {
    form.shapes.links.push_back({links_.name(g), Pose()});
    for (const DescribedSolid& described : links_.solids(g))
      form.shapes.shapes.push_back({described.solid, described.pose, g});
  }
  form.extent = extentOf(form.shapes);
  if (links_.limits()) form.jaw = Range{(*links_.limits())[0], (*links_.limits())[1]};
  return form;
}

ToolReport JawedTool::report() const {
  ToolReport report = Tool::report();
  if (!pose() || in_step_.felt.empty()) return report;
  for (int g = 0; g < groups(); ++g)
    report.jaw_torque +=
        links_.effort(g, seenFrom(in_step_.groups[0].from, in_step_.felt[static_cast<std::size_t>(g)]));
  return report;
}

JawLinks jawLinksOf(const ToolSettings& settings, const Description& description) {
  return JawLinks(description, settings.link, settings.jaw->joint);
}

Touching jawTouching(const ToolSettings& settings, const JawLinks& links, const std::vector<std::optional<Edge>>& edges,
                     ContactSkin* skin) {
  Touching touching;
  if (!skin) return touching;
  for (int g = 0; g < links.groups(); ++g) {
    if (links.solids(g).empty()) continue;
    const std::size_t index = static_cast<std::size_t>(g);
    touching.push_back(std::make_unique<ToolContact>(g, shapesOf(links, g), settings.friction,
                                                     index < edges.size() ? edges[index] : std::nullopt, skin));
  }
  return touching;
}

}  // namespace incision
