#include "incision/tool/scissors/scissors.h"

#include <utility>

namespace incision {
namespace {

std::vector<EdgeOfTool> edgesOf(const ToolSettings& settings, const ScissorEdges& edges) {
  const CuttingResistance& resistance = std::get<ScissorsSettings>(settings.kind).cutting.resistance;
  std::vector<EdgeOfTool> of_tool;
  for (int i = 0; i < 2; ++i)
    of_tool.push_back({edges.edges[i].group,
                       edges.edges[i].edge,
                       {edges.thickness[i], edges.thickness[i]},
                       resistance,
                       settings.friction});
  return of_tool;
}

}  // namespace

Scissors::Scissors(const ToolSettings& settings, JawLinks links, const ScissorEdges& edges,
                   const ToolSurroundings& surroundings, Touching touching)
    : CuttingTool(edgesOf(settings, edges), std::get<ScissorsSettings>(settings.kind).cutting.progressive, surroundings,
                  settings, std::move(links), std::move(touching)),
      closed_(this->links().limits() ? (*this->links().limits())[0] : 0) {}

void Scissors::start(const std::vector<Vec3>& x) {
  const bool opens = in_step_.jaw_to > in_step_.jaw_from, is_closed = in_step_.jaw_from <= closed_;
  if (opens || is_closed) in_step_.active = false;
  if (in_step_.active) CuttingTool::start(x);
}

std::unique_ptr<Tool> makeScissors(const ToolSettings& settings, const Description& description,
                                   const ToolSurroundings& surroundings) {
  JawLinks links = jawLinksOf(settings, description);
  const ScissorEdges edges = scissorEdges(links, jointInMessage(description.name, settings.jaw->joint));
  std::vector<std::optional<Edge>> of_groups(static_cast<std::size_t>(links.groups()));
  for (const ToolForm::GroupEdge& edge : edges.edges) of_groups[static_cast<std::size_t>(edge.group)] = edge.edge;
  Touching touching = jawTouching(settings, links, of_groups, surroundings.skin);
  return std::make_unique<Scissors>(settings, std::move(links), edges, surroundings, std::move(touching));
}

}  // namespace incision
