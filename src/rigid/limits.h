#pragma once

#include <string>

namespace incision {

/// Sizes and coordinates [m] from a micrometre to a thousand kilometres: beyond these it is a slip of units, and what
/// is reckoned with them would lose its digits.
inline constexpr double MIN_SIZE = 1e-6, MAX_LENGTH = 1e6;

/// Throws InputError "what VALUE (allowed: …)" unless the length of a solid [m] is in range.
void checkLength(double length, const std::string& what);

/// Throws InputError "what VALUE (allowed: …)" unless the coordinate [m] is in range.
void checkCoordinate(double coordinate, const std::string& what);

}  // namespace incision
