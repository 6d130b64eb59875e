#pragma once

#include <optional>
#include <string>
#include <variant>

#include "incision/tool/settings.h"

namespace incision {

/// A blade on the link `blade` of a description that is a file of that name.
inline ToolSettings bladeTool(const std::optional<Edge>& edge, const std::string& description = "") {
  ToolSettings tool;
  tool.description = description;
  tool.link = "blade";
  tool.kind = BladeSettings{edge};
  return tool;
}

inline BladeSettings& bladeOf(ToolSettings* tool) { return std::get<BladeSettings>(tool->kind); }

}  // namespace incision
