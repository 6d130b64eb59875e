#include "incision/tool/probe/settings.h"

#include "incision/base/yaml_reader.h"

namespace incision {

ProbeSettings parseProbe(const YamlMap& tool) {
  tool.at("description");
  tool.at("link");
  return {};
}

}  // namespace incision
