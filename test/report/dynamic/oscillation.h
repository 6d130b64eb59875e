#pragma once

#include <nlohmann/json.hpp>

namespace incision::report {

/// How a clamped, linear bar swings freely in its first mode: how much of its amplitude is left after a period, and how
/// much longer the period is, for each scheme and Δt as a share of the period. The formulas' own answers stand beside,
/// and how far off their factor of a step is.
nlohmann::json freeOscillation();

}  // namespace incision::report
