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
  bool progressive = true;  ///< an element's crack opens as the blade sweeps it; false: elements are cut whole
};

/// Its keys in a tool's entry: `edge`, `cutting_force`, `progressive`. Throws InputError.
BladeSettings parseBlade(const YamlMap& tool);

}  // namespace incision
