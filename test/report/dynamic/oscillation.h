#pragma once

#include <nlohmann/json.hpp>

#include "report/findings.h"

namespace incision::report {

/// How a clamped, linear bar swings freely in its first mode: how much of its amplitude is left after a period, and how
/// much longer the period is, for each scheme and Δt as a share of the period. The formulas' own answers stand beside.
nlohmann::json freeOscillation(Findings* findings);

}  // namespace incision::report
