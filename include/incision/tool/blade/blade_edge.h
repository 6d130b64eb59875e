#pragma once

#include "incision/rigid/description.h"
#include "incision/tool/settings.h"

namespace incision {

/// The cutting edge in the blade link's frame: the tool's own, or else the edge of the first collision of its link that
/// has one, which is a box. Throws InputError when the description lacks the link, or gives no edge.
Edge bladeEdge(const ToolSettings& tool, const Description& description);

}  // namespace incision
