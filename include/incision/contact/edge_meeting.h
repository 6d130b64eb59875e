#pragma once

#include <algorithm>
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

/// Where the lines through two edges come nearest to each other.
struct EdgeCrossing {
  double s, t;    ///< along the one edge and the other, each of which goes from 0 to 1
  Vec3 normal;    ///< unit, at right angles to both
  double apart;   ///< along it, from the other to the one [m]
  bool parallel;  ///< so nearly that all this means little

  /// Whether that is between the ends of both, but for so much of each at its ends.
  bool isWithin(double at_end) const { return std::min(s, t) > at_end && std::max(s, t) < 1 - at_end; }
};

/// Of an edge that starts at `a` and goes by `u`, and another that starts at `b` and goes by `v` [m].
EdgeCrossing crossingOf(const Vec3& a, const Vec3& u, const Vec3& b, const Vec3& v);

/// Whether two edges may meet in the step: they cross when they come nearest in it, or when it starts, and there the
/// one's piece lies on one side of the plane through both, the other's piece on the other.
std::optional<EdgeMeeting> meetEdges(const SkinInStep& skin, int edge, int other);

}  // namespace incision
