#include "incision/tool/blade/blade.h"

#include <utility>

#include "incision/tool/blade/blade_edge.h"

namespace incision {
namespace {

const CuttingSettings& ofBlade(const ToolSettings& settings) { return std::get<BladeSettings>(settings.kind).cutting; }

}  // namespace

Blade::Blade(const ToolSettings& settings, const Edge& edge, const std::array<double, 2>& fronts,
             const ToolSurroundings& surroundings, Touching touching)
    : CuttingTool({{0, edge, fronts, ofBlade(settings).resistance, settings.friction}}, ofBlade(settings).progressive,
                  surroundings, settings, std::move(touching)) {}

ToolForm Blade::form() const {
  ToolForm form = CuttingTool::form();
  form.extent = form.edges[0].edge;
  return form;
}

std::unique_ptr<Tool> makeBlade(const ToolSettings& settings, const Description& description,
                                const ToolSurroundings& surroundings) {
  const Edge edge = bladeEdge(settings, description);
  return std::make_unique<Blade>(settings, edge, tipFronts(edge, settings, description), surroundings,
                                 linkTouching(settings, description, edge, surroundings.skin));
}

}  // namespace incision
