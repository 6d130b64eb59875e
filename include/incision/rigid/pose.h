#pragma once

#include <Eigen/Geometry>
#include <array>

#include "incision/base/memory_limits.h"
#include "incision/rigid/wrench.h"

namespace incision {

/// How far from 1 the length of a quaternion may be before it is a mistake rather than rounding; tf2 has as much.
inline constexpr double QUATERNION_TOLERANCE = 1e-2;

/// Where a rigid thing stands: turned, then moved, it comes from its own frame into another.
struct Pose {
  Vec3 position = Vec3::Zero();                                     ///< [m]
  Eigen::Quaterniond orientation = Eigen::Quaterniond::Identity();  ///< of length 1
};

/// Whether they are the same numbers.
bool operator==(const Pose& a, const Pose& b);

template <class Archive>
void serialize(Archive& archive, Pose& pose) {
  auto& [position, orientation] = pose;
  archive(position, orientation);
}

void check(const Pose& pose, const MemoryLimits& limits);

/// A cutting edge: its two ends [m].
using Edge = std::array<Vec3, 2>;

/// The pose in the outer frame of what stands at `inner` in a frame that stands at `outer`.
Pose composed(const Pose& outer, const Pose& inner);

/// The pose of the outer frame in a frame that stands at `pose` in it.
Pose inverse(const Pose& pose);

/// The pose a share `s`, from 0 to 1, of the even way from `a` to `b`.
Pose between(const Pose& a, const Pose& b, double s);

/// A point, or an edge, of a frame [m] in the outer one, in which the frame stands at `pose`.
inline Vec3 placed(const Vec3& point, const Pose& pose) { return pose.position + pose.orientation * point; }
Edge placed(const Edge& edge, const Pose& pose);

/// The point of the edge that is nearest to `point`.
Vec3 nearestOn(const Edge& edge, const Vec3& point);

/// A wrench about the origin of the outer frame, as a frame that stands at `pose` in it has it: in its axes, about its
/// own origin.
Wrench seenFrom(const Pose& pose, const Wrench& wrench);

}  // namespace incision
