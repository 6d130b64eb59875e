#pragma once

#include <optional>

#include "incision/rigid/pose.h"

namespace incision {

class YamlMap;

/// What a blade has beside what all tools have.
struct BladeSettings {
  std::optional<Edge> edge = {};  ///< in the link's frame; absent: the longest edge of the link's first collision box
  /// [N/m] of edge in the tissue: the fracture energy [J/m²] of what it cuts; regions may differ.
  double cutting_force = 0;
  double cutting_viscosity = 0;  ///< [N s/m²] what it grows by with the edge's speed through the tissue; likewise
  double cutting_onset = 0;      ///< [N/m] what cutting takes beyond it where nothing is cut yet; likewise
  bool progressive = true;       ///< an element's crack opens as the blade sweeps it; false: elements are cut whole
};

/// Its keys in a tool's entry: `edge`, `cutting_force`, `cutting_viscosity`, `cutting_onset`, `progressive`. Throws
/// InputError.
BladeSettings parseBlade(const YamlMap& tool);

}  // namespace incision
