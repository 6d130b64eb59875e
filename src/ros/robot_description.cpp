#include "incision/ros/robot_description.h"

#include <fstream>
#include <sstream>

#include "incision/mesh/input_error.h"

namespace incision {
namespace {

std::string readFile(const std::string& path) {
  std::ifstream file(path);
  std::ostringstream text;
  text << file.rdbuf();
  if (!file) throw InputError(path + ": the tool's description cannot be read");
  return text.str();
}

}  // namespace

std::string toolDescription(const ros::NodeHandle& node, const Scene& scene) {
  std::string key, text;
  if (node.searchParam("tool_description", key)) {
    if (!node.getParam(key, text)) throw InputError(key + ": not a text; must be a URDF description");
    return text;
  }
  if (!scene.tool || scene.tool->description.empty()) return "";
  return readFile(resolvePath(scene.tool->description, ""));
}

}  // namespace incision
