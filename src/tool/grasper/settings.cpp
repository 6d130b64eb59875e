#include "incision/tool/grasper/settings.h"

#include "incision/base/yaml_reader.h"

namespace incision {

GrasperSettings parseGrasper(const YamlMap& tool) {
  tool.at("description");
  tool.at("link");
  GrasperSettings grasper;
  grasper.closed = tool.at("closed").number();
  grasper.grip = tool.at("grip").number(POSITIVE);
  return grasper;
}

}  // namespace incision
