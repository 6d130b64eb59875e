#pragma once

#include <memory>

#include "incision/tool/blade/cutting_tool.h"

namespace incision {

/// A tool with a cutting edge: what that sweeps is cut, and the shapes of its link push.
class Blade : public CuttingTool<Tool> {
 public:
  /// `edge` in the frame of its link, `fronts` as tipFronts has them.
  Blade(const ToolSettings& settings, const Edge& edge, const std::array<double, 2>& fronts,
        const ToolSurroundings& surroundings, Touching touching);

  ToolForm form() const override;
};

/// As ToolKind::make says.
std::unique_ptr<Tool> makeBlade(const ToolSettings& settings, const Description& description,
                                const ToolSurroundings& surroundings);

}  // namespace incision
