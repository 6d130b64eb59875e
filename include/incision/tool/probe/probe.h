#pragma once

#include <memory>

#include "incision/tool/kinds.h"

namespace incision {

/// As ToolKind::make says: a probe is a tool that does no more than all do, which is to touch.
std::unique_ptr<Tool> makeProbe(const ToolSettings& settings, const Description& description,
                                const ToolSurroundings& surroundings);

}  // namespace incision
