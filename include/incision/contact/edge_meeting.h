#pragma once

#include <optional>

#include "incision/contact/skin_in_step.h"

namespace incision {

/// Two edges of different pieces that cross each other.
struct EdgeMeeting {
  int edge, other;
  Vec3 normal;           ///< across both, from the other's piece to the one's; unit
  double share, there;   ///< where on the one and on the other, from their first vertices on
  double gap;            ///< along the normal when the step starts [m]
  bool goes_on = false;  ///< from a meeting in the last step
};

/// Whether two edges may meet in the step: they cross when they come nearest in it, or when it starts, and there the
/// one's piece lies on one side of the plane through both, the other's piece on the other.
std::optional<EdgeMeeting> meetEdges(const SkinInStep& skin, int edge, int other);

}  // namespace incision
