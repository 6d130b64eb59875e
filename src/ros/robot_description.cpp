#include "incision/ros/robot_description.h"

#include "incision/base/input_error.h"
#include "incision/base/read_text.h"

namespace incision {

namespace {

/// The full name of a description's parameter; empty when it is not set.
std::string findParameter(const ros::NodeHandle& node, const std::string& name) {
  std::string key;
  return node.searchParam(name, key) ? key : "";
}

std::string readParameter(const ros::NodeHandle& node, const std::string& key) {
  std::string text;
  if (!node.getParam(key, text)) throw InputError(key + ": not a text (allowed: a URDF description)");
  if (text.size() > MAX_TEXT)
    throw InputError(key + ": the text is too large (allowed: up to " + std::to_string(MAX_TEXT) + " bytes)");
  return text;
}

}  // namespace

Descriptions readDescriptions(const ros::NodeHandle& node, Scene* scene) {
  const std::string of_tools = findParameter(node, "tool_description");
  const std::string of_obstacles = findParameter(node, "obstacle_description");
  Scene rest = *scene;  // what files are still to be read for
  if (!of_tools.empty())
    for (ToolSettings& tool : rest.tools) tool.description.clear();
  if (!of_obstacles.empty()) rest.contact.reset();
  Descriptions texts = loadDescriptions(rest);
  if (!of_tools.empty() && !scene->tools.empty())
    texts.tools.assign(scene->tools.size(), readParameter(node, of_tools));
  if (of_obstacles.empty()) return texts;
  if (!scene->contact) scene->contact.emplace();
  scene->contact->obstacles = of_obstacles;
  texts.obstacles = readParameter(node, of_obstacles);
  return texts;
}

}  // namespace incision
