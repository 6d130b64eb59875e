#include "incision/tool/blade/cutting_settings.h"

#include "incision/base/yaml_reader.h"

namespace incision {

CuttingSettings parseCutting(const YamlMap& tool) {
  CuttingSettings cutting;
  CuttingResistance& resistance = cutting.resistance;
  resistance.force = tool.number("cutting_force", resistance.force, NOT_NEGATIVE);
  resistance.viscosity = tool.number("cutting_viscosity", resistance.viscosity, NOT_NEGATIVE);
  resistance.onset = tool.number("cutting_onset", resistance.onset, NOT_NEGATIVE);
  if (const auto progressive = tool.find("progressive")) cutting.progressive = progressive->boolean();
  return cutting;
}

}  // namespace incision
