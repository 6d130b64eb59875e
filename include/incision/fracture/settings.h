#pragma once

#include <limits>
#include <optional>
#include <vector>

#include "incision/base/range.h"
#include "incision/fem/region_settings.h"

namespace incision {

class YamlValue;

/// When and how the body breaks by itself. Stresses are positive in tension.
struct FractureSettings {
  static constexpr Range FUSE_ANGLE = {0, 1.5707963267948966};  ///< [rad], up to a quarter turn

  /// Largest principal stress [Pa] that the material bears, > 0.
  double tensile_strength = std::numeric_limits<double>::infinity();
  /// Largest compression [Pa] that it bears, > 0.
  double compressive_strength = std::numeric_limits<double>::infinity();
  /// How fast a crack runs [m/s], > 0; besides, it passes at most one element in a step.
  double crack_speed = std::numeric_limits<double>::infinity();
  /// A crack that comes so near [m] to another runs into it, ≥ 0; 0: cracks do not see each other.
  double fuse_distance = 0;
  /// Largest angle [rad] between two fringes that become one crack, in FUSE_ANGLE.
  double fuse_angle = 0;
  /// Energy G [J/m²] that opening a crack takes, > 0. Without it cracks open freely.
  std::optional<double> fracture_energy;
};

/// The section `fracture`, for a body with these regions. Throws InputError.
FractureSettings parseFracture(const YamlValue& value, const std::vector<RegionSettings>& regions = {});

}  // namespace incision
