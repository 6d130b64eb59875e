#pragma once

#include "incision/tool/blade/cutting_resistance.h"

namespace incision {

class YamlMap;

/// How a tool's edges cut.
struct CuttingSettings {
  CuttingResistance resistance;  ///< of what they cut; regions may differ
  bool progressive = true;       ///< an element's crack opens as an edge sweeps it; false: elements are cut whole
};

/// Its keys in a tool's entry: `cutting_force` (the fracture energy [J/m²] of what is cut), `cutting_viscosity`,
/// `cutting_onset`, `progressive`. Throws InputError.
CuttingSettings parseCutting(const YamlMap& tool);

}  // namespace incision
