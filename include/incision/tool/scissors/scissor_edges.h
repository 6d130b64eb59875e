#pragma once

#include <array>

#include "incision/rigid/jaw_links.h"
#include "incision/tool/tool_form.h"

namespace incision {

/// The two edges of scissors whose blades are the first boxes of two groups, and how thick the blades are [m]. Each
/// edge runs along the middle of that long face of its box which leads in closing. Both lie in one plane across the
/// joint's axis, midway between the boxes, as blades that slide past each other cut in one plane:
///
///         ───────────┐ box          seen along the joint's axis
///     o   ═══════════   its edge
///         ═══════════   that of the other, which comes towards it
///         ───────────┘
///
struct ScissorEdges {
  std::array<ToolForm::GroupEdge, 2> edges;
  std::array<double, 2> thickness;
};

/// Throws InputError where there are not two blades with a box that the joint moves towards each other. `where` is what
/// errors call the description's joint.
ScissorEdges scissorEdges(const JawLinks& links, const std::string& where);

}  // namespace incision
