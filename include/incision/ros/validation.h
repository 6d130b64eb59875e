#pragma once

#include <geometry_msgs/PoseStamped.h>
#include <incision/CutPlane.h>

#include <optional>
#include <string>

#include "incision/pace/command.h"

namespace incision {

/// Why this message cannot be used, or nothing when it can.
std::optional<Refused> whyRefused(const CutPlane& message);
std::optional<Refused> whyRefused(const geometry_msgs::PoseStamped& message);

/// The command in a message that can be used. An empty frame means `body_frame`.
Command toCommand(const CutPlane& message, const std::string& body_frame, SteadyTime received);
Command toCommand(const geometry_msgs::PoseStamped& message, int tool, const std::string& body_frame,
                  SteadyTime received);

}  // namespace incision
