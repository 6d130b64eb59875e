#include "incision/tool/grasper/settings.h"

#include "incision/base/yaml_reader.h"

namespace incision {

GrasperSettings parseGrasper(const YamlMap& tool) {
  GrasperSettings grasper;
  grasper.closed = tool.at("closed").number();
  grasper.grip = tool.at("grip").number(POSITIVE);
  return grasper;
}

}  // namespace incision
