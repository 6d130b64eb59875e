#include "incision/tool/blade/blade.h"

#include <utility>

#include "incision/tool/blade/blade_edge.h"

namespace incision {

Blade::Blade(const ToolSettings& settings, const Edge& edge, const std::array<double, 2>& fronts,
             const ToolSurroundings& surroundings, Touching touching)
    : Tool(settings, std::move(touching)),
      edge_(settings.name, {{0, edge, fronts, std::get<BladeSettings>(settings.kind).cutting_force, settings.friction}},
            std::get<BladeSettings>(settings.kind).progressive, &in_step_, &surroundings.ties, surroundings.materials,
            surroundings.mesh) {}

ToolForm Blade::form() const {
  ToolForm form = Tool::form();
  form.extent = edge_.edges()[0].edge;
  form.edges = {{0, form.extent}};
  return form;
}

std::vector<Coupler*> Blade::couplers() {
  std::vector<Coupler*> list = Tool::couplers();
  edge_.addCouplers(&list);
  return list;
}

void Blade::recall(const std::any& kept) {
  const auto& memory = std::any_cast<const BladeMemory&>(kept);
  tool_ = memory.tool;
  edge_.recall(memory.edge);
}

ToolReport Blade::report() const {
  ToolReport report = Tool::report();
  if (pose()) edge_.addTo(&report);
  return report;
}

std::unique_ptr<Tool> makeBlade(const ToolSettings& settings, const Description& description,
                                const ToolSurroundings& surroundings) {
  const Edge edge = bladeEdge(settings, description);
  return std::make_unique<Blade>(settings, edge, tipFronts(edge, settings, description), surroundings,
                                 linkTouching(settings, description, edge, surroundings.skin));
}

}  // namespace incision
