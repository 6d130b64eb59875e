#include "incision/ros/robot_description.h"

#include "incision/body/read_text.h"
#include "incision/mesh/input_error.h"

namespace incision {

std::string toolDescription(const ros::NodeHandle& node, const Scene& scene) {
  std::string key, text;
  if (!scene.tool || !node.searchParam("tool_description", key)) return loadDescription(scene);
  if (!node.getParam(key, text)) throw InputError(key + ": not a text (allowed: a URDF description)");
  if (text.size() > MAX_TEXT)
    throw InputError(key + ": the text is too large (allowed: up to " + std::to_string(MAX_TEXT) + " bytes)");
  return text;
}

}  // namespace incision
