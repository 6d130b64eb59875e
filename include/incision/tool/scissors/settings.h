#pragma once

#include "incision/tool/blade/cutting_settings.h"

namespace incision {

/// What scissors have beside what all tools have.
struct ScissorsSettings {
  CuttingSettings cutting = {};  ///< of each edge
};

/// Their keys in a tool's entry: those of CuttingSettings. Throws InputError.
inline ScissorsSettings parseScissors(const YamlMap& tool) { return {parseCutting(tool)}; }

}  // namespace incision
