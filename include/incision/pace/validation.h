#pragma once

#include <cstddef>
#include <optional>
#include <string>

#include "incision/pace/command.h"

namespace incision {

/// Longest frame name; tf's own are far shorter.
inline constexpr std::size_t MAX_FRAME = 256;

/// Largest coordinate [m] of a pose: that which cut planes may have.
inline constexpr double MAX_POSITION = 1e9;

/// Why this cannot be used, or nothing when it can. A pose's quaternion may have any length here.
std::optional<Refused> whyRefused(const PlaneCut& plane);
std::optional<Refused> whyRefused(const Pose& pose);

/// Why a frame cannot have this name.
std::optional<Refused> whyRefusedFrame(const std::string& name);

}  // namespace incision
