#include "incision/tool/settings.h"

#include "incision/base/yaml_reader.h"
#include "incision/tool/kinds.h"

namespace incision {
namespace {

const ToolKind& parseKind(const YamlValue& value) {
  std::map<std::string, const ToolKind*> kinds;
  for (const ToolKind& kind : toolKinds()) kinds[kind.name] = &kind;
  return *value.choice(kinds);
}

/// Which kind an entry says that it is, whatever else it has.
const ToolKind& kindIn(const YamlValue& value) {
  const auto type = value.peek("type");
  if (type) return parseKind(*type);
  std::vector<std::string> names;
  for (const ToolKind& kind : toolKinds()) names.push_back(kind.name);
  value.fail("the key type is missing (allowed: " + joined(names) + ")");
}

JawSettings parseJaw(const YamlMap& map) {
  JawSettings jaw;
  jaw.joint = map.at("joint").text(MAX_NAME);
  parseAnglesOf(map, &jaw.angles, &jaw.file);
  return jaw;
}

ToolSettings parseTool(const std::string& name, const YamlValue& value) {
  const ToolKind& kind = kindIn(value);
  std::vector<std::string> keys = {"type",     "description", "link",  "poses",   "poses_file",
                                   "max_step", "timeout",     "frame", "friction"};
  keys.insert(keys.end(), kind.keys.begin(), kind.keys.end());
  if (kind.has_jaw) keys.insert(keys.end(), {"joint", "jaw", "jaw_file"});
  const YamlMap map = value.map(keys);
  ToolSettings tool;
  tool.name = name;
  if (const auto description = map.find("description")) tool.description = description->path();
  if (const auto link = map.find("link")) tool.link = link->text(MAX_NAME);
  if (kind.needs_description)
    for (const char* key : {"description", "link"}) map.at(key);
  tool.kind = kind.parse(map);
  parsePosesOf(map, &tool.poses, &tool.poses_file);
  if (const auto frame = map.find("frame")) tool.frame = frame->frame();
  if (kind.has_jaw) tool.jaw = parseJaw(map);
  tool.max_step = map.numberOrInfinity("max_step", tool.max_step, POSITIVE);
  tool.timeout = map.numberOrInfinity("timeout", tool.timeout, POSITIVE);
  tool.friction = map.number("friction", tool.friction, FRICTION);
  return tool;
}

}  // namespace

std::vector<ToolSettings> parseTools(const YamlValue& value) {
  std::vector<ToolSettings> tools;
  for (const auto& [name, entry] : value.named(MAX_TOOLS)) {
    const auto is_letter = [](char c) { return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z'); };
    if (!is_letter(name[0]) || name.find('-') != std::string::npos)
      entry.fail("the name of a tool is part of its topics' (allowed: letters, digits and _, a letter first)");
    tools.push_back(parseTool(name, entry));
  }
  return tools;
}

}  // namespace incision
