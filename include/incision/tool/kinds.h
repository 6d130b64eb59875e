#pragma once

#include <memory>
#include <string>
#include <vector>

#include "incision/rigid/description.h"
#include "incision/tool/blade/ties.h"
#include "incision/tool/near_parts.h"
#include "incision/tool/tool.h"

namespace incision {

class YamlMap;

/// What a tool is made for. All of it must outlive the tool.
struct ToolSurroundings {
  const CutMesh& mesh;
  const Materials& materials;
  Ties& ties;         ///< of what edges have not swept yet, one for all tools of a body
  NearParts& near;    ///< finds what edges come by, likewise
  ContactSkin* skin;  ///< null: nothing touches
};

/// A kind of tool. A new one is a folder of its own, a line in the list of them and an alternative of KindSettings.
struct ToolKind {
  std::string name;               ///< its `type` in a scene
  std::vector<std::string> keys;  ///< that its tools have beside those of all tools
  bool has_jaw;                   ///< it opens and closes
  bool needs_description;         ///< the keys `description` and `link` must be there
  KindSettings (*parse)(const YamlMap& tool);
  /// `description` has no links where the settings name none. Throws InputError when it does not go with the settings.
  std::unique_ptr<Tool> (*make)(const ToolSettings& settings, const Description& description,
                                const ToolSurroundings& surroundings);
};

/// All there are, in the order of the alternatives of KindSettings.
const std::vector<ToolKind>& toolKinds();

/// The kind of a tool.
inline const ToolKind& kindOf(const ToolSettings& settings) { return toolKinds()[settings.kind.index()]; }

/// The shapes of one link that touch with the tool's friction, as group 0 of what moves together; none where nothing
/// touches or the link has none. Throws InputError for shapes that cannot be used.
Touching linkTouching(const ToolSettings& settings, const Description& description, const std::optional<Edge>& edge,
                      ContactSkin* skin);

/// The tool that the settings ask for. `urdf` is the text of its description, where it has one. Throws InputError when
/// that does not go with the settings.
std::unique_ptr<Tool> makeTool(const ToolSettings& settings, const std::string& urdf,
                               const ToolSurroundings& surroundings);

}  // namespace incision
