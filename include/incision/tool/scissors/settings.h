#pragma once

namespace incision {

class YamlMap;

/// What scissors have beside what all tools have.
struct ScissorsSettings {
  /// [N/m] of each edge in the tissue: the fracture energy [J/m²] of what they cut; regions may differ.
  double cutting_force = 0;
  double cutting_viscosity = 0;  ///< [N s/m²] as BladeSettings says
  double cutting_onset = 0;      ///< [N/m] likewise
  bool progressive = true;       ///< an element's crack opens as an edge sweeps it; false: elements are cut whole
};

/// Their keys in a tool's entry. Throws InputError.
ScissorsSettings parseScissors(const YamlMap& tool);

}  // namespace incision
