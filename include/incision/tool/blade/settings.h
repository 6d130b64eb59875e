#pragma once

#include <optional>

#include "incision/rigid/pose.h"
#include "incision/tool/blade/cutting_settings.h"

namespace incision {

class YamlMap;

/// What a blade has beside what all tools have.
struct BladeSettings {
  std::optional<Edge> edge = {};  ///< in the link's frame; absent: the longest edge of the link's first collision box
  CuttingSettings cutting = {};
};

/// Its keys in a tool's entry: `edge`, and those of CuttingSettings. Throws InputError.
BladeSettings parseBlade(const YamlMap& tool);

}  // namespace incision
