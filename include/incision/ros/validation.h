#pragma once

#include <geometry_msgs/PoseStamped.h>
#include <incision/CutPlane.h>
#include <sensor_msgs/JointState.h>

#include <optional>
#include <string>

#include "incision/base/range.h"
#include "incision/pace/command.h"

namespace incision {

/// Why this message cannot be used, or nothing when it can.
std::optional<Refused> whyRefused(const CutPlane& message);
std::optional<Refused> whyRefused(const geometry_msgs::PoseStamped& message);

/// The joint of a tool's jaw.
struct Jaw {
  std::string joint;
  Range angles;  ///< where it can go [rad]
};
/// A message of where the jaw shall go has one position; a name may stand beside it.
std::optional<Refused> whyRefused(const sensor_msgs::JointState& message, const Jaw& jaw);

/// The command in a message that can be used. An empty frame means `body_frame`.
Command toCommand(const CutPlane& message, const std::string& body_frame, SteadyTime received);
Command toCommand(const geometry_msgs::PoseStamped& message, int tool, const std::string& body_frame,
                  SteadyTime received);

}  // namespace incision
