#include "incision/tool/scissors/settings.h"

#include "incision/base/yaml_reader.h"

namespace incision {

ScissorsSettings parseScissors(const YamlMap& tool) {
  ScissorsSettings scissors;
  scissors.cutting_force = tool.number("cutting_force", scissors.cutting_force, NOT_NEGATIVE);
  scissors.cutting_viscosity = tool.number("cutting_viscosity", scissors.cutting_viscosity, NOT_NEGATIVE);
  scissors.cutting_onset = tool.number("cutting_onset", scissors.cutting_onset, NOT_NEGATIVE);
  if (const auto progressive = tool.find("progressive")) scissors.progressive = progressive->boolean();
  return scissors;
}

}  // namespace incision
