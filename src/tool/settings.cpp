#include "incision/tool/settings.h"

#include "incision/base/yaml_reader.h"

namespace incision {

ToolSettings parseTool(const YamlValue& value) {
  const YamlMap map = value.map({"description", "link", "edge", "poses", "poses_file", "frame", "max_step", "timeout",
                                 "cutting_force", "friction", "progressive"});
  ToolSettings tool;
  if (!map.has("edge") && !map.has("description")) value.fail("needs an edge, or a description that has one");
  if (const auto description = map.find("description")) tool.description = description->path();
  if (const auto edge = map.find("edge")) {
    const std::vector<YamlValue> ends = edge->list(2);
    tool.edge = {ends[0].vector(), ends[1].vector()};
    if ((*tool.edge)[0] == (*tool.edge)[1]) edge->fail("both ends are the same point (allowed: two points)");
    if (const auto link = map.find("link")) tool.link = link->text(MAX_NAME);
  } else {
    tool.link = map.at("link").text(MAX_NAME);
  }
  parsePosesOf(map, &tool.poses, &tool.poses_file);
  if (const auto frame = map.find("frame")) tool.frame = frame->frame();
  tool.max_step = map.numberOrInfinity("max_step", tool.max_step, POSITIVE);
  tool.timeout = map.numberOrInfinity("timeout", tool.timeout, POSITIVE);
  tool.cutting_force = map.number("cutting_force", tool.cutting_force, NOT_NEGATIVE);
  tool.friction = map.number("friction", tool.friction, FRICTION);
  if (const auto progressive = map.find("progressive")) tool.progressive = progressive->boolean();
  return tool;
}

}  // namespace incision
