#pragma once

#include <geometry_msgs/PoseStamped.h>
#include <incision/CutPlane.h>

#include <optional>

#include "incision/pace/command.h"

namespace incision {

/// Longest frame name; tf's own are far shorter.
inline constexpr std::size_t MAX_FRAME = 256;

/// Largest coordinate [m] of a tool pose, as for cut planes.
inline constexpr double MAX_POSITION = 1e9;

/// How far a quaternion's length may be from 1; tf2 allows the same.
inline constexpr double QUATERNION_TOLERANCE = 0.01;

/// Why this message cannot be used, or nothing when it can.
std::optional<Refused> whyRefused(const CutPlane& message);
std::optional<Refused> whyRefused(const geometry_msgs::PoseStamped& message);

/// The command in a message that can be used. An empty frame means `body_frame`.
Command toCommand(const CutPlane& message, const std::string& body_frame, SteadyTime received);
Command toCommand(const geometry_msgs::PoseStamped& message, const std::string& body_frame, SteadyTime received);

}  // namespace incision
