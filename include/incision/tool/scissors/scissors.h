#pragma once

#include <memory>

#include "incision/tool/blade/cutting_tool.h"
#include "incision/tool/jawed_tool.h"
#include "incision/tool/scissors/scissor_edges.h"

namespace incision {

/// Two blades on a joint, whose edges cut what lies between them. Where the joint opens, and while it is closed as far
/// as it goes, they only touch: so they spread tissue, and can be led into it.
class Scissors : public CuttingTool<JawedTool> {
 public:
  Scissors(const ToolSettings& settings, JawLinks links, const ScissorEdges& edges,
           const ToolSurroundings& surroundings, Touching touching);

 protected:
  void start(const std::vector<Vec3>& x) override;

 private:
  double closed_;  // the least angle of the joint [rad]; 0 where it has no limits
};

/// As ToolKind::make says.
std::unique_ptr<Tool> makeScissors(const ToolSettings& settings, const Description& description,
                                   const ToolSurroundings& surroundings);

}  // namespace incision
