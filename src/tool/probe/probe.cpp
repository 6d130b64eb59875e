#include "incision/tool/probe/probe.h"

#include "incision/base/input_error.h"

namespace incision {

std::unique_ptr<Tool> makeProbe(const ToolSettings& settings, const Description& description,
                                const ToolSurroundings& surroundings) {
  if (description.link(settings.link).solids.empty())
    throw InputError(linkInMessage(description.name, settings.link) + " has no collision shape: the probe '" +
                     settings.name + "' would touch nothing");
  return std::make_unique<Tool>(settings, linkTouching(settings, description, std::nullopt, surroundings.skin));
}

}  // namespace incision
