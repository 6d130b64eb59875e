#pragma once

#include <array>

#include "incision/rigid/description.h"
#include "incision/tool/settings.h"

namespace incision {

/// The cutting edge in the blade link's frame: the tool's own, or else the edge of the first collision of its link that
/// has one, which is a box. Throws InputError when the description lacks the link, or gives no edge.
Edge bladeEdge(const ToolSettings& tool, const Description& description);

/// How thick the blade is at either end of its edge [m]: what it has for a front there where it is pushed along its
/// edge. That is the thickness of a shape of its link whose surface is no farther from the end than the shape is thick,
/// the thinnest of several; 0 where there is none, as an edge alone has no front.
std::array<double, 2> tipFronts(const Edge& edge, const ToolSettings& tool, const Description& description);

}  // namespace incision
