#pragma once

#include <string>
#include <vector>

#include "incision/scene/scene.h"

namespace incision {

/// One of the node's tools. Wherever else tools have an index, it is that of this entry in the list.
struct ToolEntry {
  ToolSettings settings;
  std::string topics;  ///< what the names of its topics begin with

  /// What messages call it.
  std::string name() const { return topics.substr(0, topics.size() - 1); }
  std::string topic(const std::string& name) const { return topics + name; }
};

/// What the names of a scene's only tool's topics begin with.
inline const std::string TOOL_TOPICS = "tool_";

/// The scene's tools.
inline std::vector<ToolEntry> toolsOf(const Scene& scene) {
  if (!scene.tool) return {};
  return {{*scene.tool, TOOL_TOPICS}};
}

}  // namespace incision
