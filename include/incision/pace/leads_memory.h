#pragma once

#include <optional>
#include <string>
#include <vector>

#include "incision/pace/link_tracker.h"
#include "incision/pace/tool_guide.h"

namespace incision {

/// How a StepInput leads what moves, as far as that outlasts a step: each tool, each link of the obstacles, each clamp
/// that has a frame.
struct LeadsMemory {
  std::vector<ToolGuideMemory> tools;
  std::vector<FollowedLinkMemory> obstacles, clamps;
};

std::string toBytes(const LeadsMemory& memory);

/// From such bytes, of as many tools, links and clamps as `alike` has; nothing from none. Throws InputError where no
/// node can have been so.
std::optional<LeadsMemory> readLeads(const std::string& bytes, const LeadsMemory& alike);

}  // namespace incision
