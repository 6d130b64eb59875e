#pragma once

#include <limits>

namespace incision {

/// Which finite numbers are allowed; the ends belong to it.
struct Range {
  double min = std::numeric_limits<double>::lowest();
  double max = std::numeric_limits<double>::max();
};

/// The smallest number above zero: `{ABOVE_ZERO}` allows all positive numbers.
inline constexpr double ABOVE_ZERO = std::numeric_limits<double>::min();

inline constexpr Range POSITIVE = {ABOVE_ZERO};
inline constexpr Range NOT_NEGATIVE = {0};

/// A simulated time [s]: some thirty years, so that a time over the shortest step still counts exactly in a double.
inline constexpr Range SIMULATED_TIME = {0, 1e9};

/// Coulomb's coefficient. Rubber on rubber has some 1.2; a material that clings has more. Above 10 nothing slides that
/// would not stick.
inline constexpr Range FRICTION = {0, 10};

}  // namespace incision
