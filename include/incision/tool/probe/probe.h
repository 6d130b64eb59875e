#pragma once

#include <memory>

#include "incision/tool/kinds.h"

namespace incision {

/// A tool that only touches.
class Probe : public Tool {
 public:
  using Tool::Tool;

  std::any keep() const override { return tool_; }
  void recall(const std::any& kept) override { tool_ = std::any_cast<const ToolMemory&>(kept); }
  void write(const std::any& kept, ArchiveWriter* archive) const override { writeKept<ToolMemory>(kept, archive); }
  std::any read(ArchiveReader* archive) const override { return readKept<ToolMemory>(archive); }
};

/// As ToolKind::make says.
std::unique_ptr<Tool> makeProbe(const ToolSettings& settings, const Description& description,
                                const ToolSurroundings& surroundings);

}  // namespace incision
