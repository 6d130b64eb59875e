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

std::string toolDescription(const ros::NodeHandle& node, const Scene& scene) {
  const std::string key = scene.tool ? findParameter(node, "tool_description") : "";
  return key.empty() ? loadDescription(scene) : readParameter(node, key);
}

std::string obstacleDescription(const ros::NodeHandle& node, Scene* scene) {
  const std::string key = findParameter(node, "obstacle_description");
  if (key.empty()) return loadObstacleDescription(*scene);
  if (!scene->contact) scene->contact.emplace();
  scene->contact->obstacles = key;
  return readParameter(node, key);
}

}  // namespace incision
