#include "incision/tool/blade/settings.h"

#include "incision/base/yaml_reader.h"

namespace incision {

BladeSettings parseBlade(const YamlMap& tool) {
  BladeSettings blade;
  if (!tool.has("edge") && !tool.has("description")) tool.whole().fail("needs an edge, or a description that has one");
  if (const auto edge = tool.find("edge")) {
    const std::vector<YamlValue> ends = edge->list(2);
    blade.edge = {ends[0].vector(), ends[1].vector()};
    if ((*blade.edge)[0] == (*blade.edge)[1]) edge->fail("both ends are the same point (allowed: two points)");
  } else {
    tool.at("link");
  }
  blade.cutting = parseCutting(tool);
  return blade;
}

}  // namespace incision
