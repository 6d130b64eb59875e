#pragma once

#include <string>

#include "incision/rigid/pose.h"
#include "incision/tool/settings.h"

namespace incision {

/// The cutting edge in the blade link's frame: the tool's own, or else the longest edge of the link's first collision
/// box. Of the four equal edges along the box's longest axis (of equal axes the first) it is the one where the other
/// two of the box's coordinates are smallest. `urdf` is the text of the description, `name` what errors call it.
/// Throws InputError when the description is unreadable or hostile, lacks the link, or gives no edge.
Edge bladeEdge(const ToolSettings& tool, const std::string& urdf, const std::string& name);

}  // namespace incision
