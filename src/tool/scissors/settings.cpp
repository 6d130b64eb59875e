#include "incision/tool/scissors/settings.h"

#include "incision/base/yaml_reader.h"

namespace incision {

ScissorsSettings parseScissors(const YamlMap& tool) {
  ScissorsSettings scissors;
  scissors.cutting_force = tool.number("cutting_force", scissors.cutting_force, NOT_NEGATIVE);
  if (const auto progressive = tool.find("progressive")) scissors.progressive = progressive->boolean();
  return scissors;
}

}  // namespace incision
