#pragma once

#include <optional>
#include <string>

#include "incision/base/range.h"
#include "incision/pace/command.h"

namespace incision {

/// Why this cannot be used, or nothing when it can. A pose's quaternion may have any length here.
std::optional<Refused> whyRefused(const PlaneCut& plane);
std::optional<Refused> whyRefused(const Pose& pose);

/// Why a jaw that can be in this range cannot go there.
std::optional<Refused> whyRefused(double angle, const Range& jaw);

/// Why a frame cannot have this name.
std::optional<Refused> whyRefusedFrame(const std::string& name);

}  // namespace incision
