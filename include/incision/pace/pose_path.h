#pragma once

#include <vector>

#include "incision/rigid/pose.h"

namespace incision {

/// A pose is left out of a path when the tool passes it within this [m] anyway: less than instruments know where they
/// are, and a small part of any element. A hand's path in one step is then one sweep or two, at any rate of poses.
inline constexpr double PATH_TOLERANCE = 1e-4;

/// How far the link's origin, or that end of the edge which moves most, is in one pose from where it is in the other
/// [m].
double travel(const Pose& from, const Pose& to, const Edge& edge);

/// The path from `from` without the poses that lie, within PATH_TOLERANCE for the link's origin and the edge's ends,
/// where the tool passes on its straight and even way between those that stay. The last one stays. Takes time linear in
/// the number of poses.
std::vector<Pose> simplified(const Pose& from, const std::vector<Pose>& path, const Edge& edge);

/// Takes from the front of the way, which begins at `from`, this share of its length, above 0 and up to 1. The rest of
/// the way then begins at the last of the poses returned.
std::vector<Pose> takeFront(double share, const Pose& from, const Edge& edge, std::vector<Pose>* way);

}  // namespace incision
