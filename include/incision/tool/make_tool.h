#pragma once

#include <memory>
#include <string>

#include "incision/tool/tool.h"

namespace incision {

/// What a tool is made for. All of it must outlive the tool.
struct ToolSurroundings {
  const CutMesh& mesh;
  const Materials& materials;
  ContactSkin* skin;  ///< null: nothing touches
};

/// A tool of the kind that the settings ask for; a new kind is a folder of its own and a line in here. `urdf` is the
/// text of the tool's description, where it needs one. Throws InputError when it does not go with the settings.
std::unique_ptr<Tool> makeTool(const ToolSettings& settings, const std::string& urdf,
                               const ToolSurroundings& surroundings);

}  // namespace incision
