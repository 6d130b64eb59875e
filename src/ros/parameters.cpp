#include "incision/ros/parameters.h"

#include <ros/console.h>
#include <yaml-cpp/yaml.h>

#include <algorithm>
#include <cmath>
#include <sstream>

#include "incision/base/input_error.h"
#include "incision/pace/pacer.h"
#include "incision/ros/robot_description.h"
#include "incision/ros/scene_parameter.h"

namespace incision {
namespace {

constexpr std::array KNOWN = {"scene",       "tool_description",  "obstacle_description",
                              "marker_rate", "transform_timeout", "max_lag"};

Scene loadSceneParameter(const ros::NodeHandle& node) {
  const std::string name = node.resolveName("scene");
  XmlRpc::XmlRpcValue value;
  if (!node.getParam("scene", value))
    throw InputError(name + ": this parameter is missing; load a scene file there, as incision.launch does");
  return parseScene(toYaml(value, name), name, "");
}

/// `number` keeps its value when the parameter is not set.
void loadNumber(const ros::NodeHandle& node, const std::string& key, double min, double max, double& number) {
  if (!node.hasParam(key)) return;
  double value = std::nan("");
  const bool is_number = node.getParam(key, value);
  if (value >= min && value <= max) {
    number = value;
    return;
  }
  std::ostringstream message;
  message << node.resolveName(key) << ": ";
  if (is_number) message << value << " is out of range; ";
  message << "must be a number from " << min << " to " << max;
  throw InputError(message.str());
}

void reportUnknown(const ros::NodeHandle& node) {
  XmlRpc::XmlRpcValue all;
  if (!node.getParam(node.getNamespace(), all) || all.getType() != XmlRpc::XmlRpcValue::TypeStruct) return;
  for (const auto& [key, value] : all)
    if (std::find(KNOWN.begin(), KNOWN.end(), key) == KNOWN.end())
      ROS_WARN_STREAM(node.resolveName(key) << ": unknown parameter, ignored");
}

}  // namespace

NodeSettings loadSettings(const ros::NodeHandle& node) {
  reportUnknown(node);
  NodeSettings settings;
  settings.scene = loadSceneParameter(node);
  settings.tools = toolsOf(settings.scene);
  settings.descriptions.tool = toolDescription(node, settings.scene);
  settings.descriptions.obstacles = obstacleDescription(node, &settings.scene);
  loadNumber(node, "marker_rate", 0, 1000, settings.marker_rate);
  loadNumber(node, "transform_timeout", 0, 60, settings.transform_timeout);
  loadNumber(node, "max_lag", MAX_CLOCK_ADVANCE, 1e6, settings.max_lag);
  return settings;
}

}  // namespace incision
