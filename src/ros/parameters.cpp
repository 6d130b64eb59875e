#include "incision/ros/parameters.h"

#include <yaml-cpp/yaml.h>

#include "incision/base/input_error.h"
#include "incision/pace/pacer.h"
#include "incision/ros/private_parameters.h"
#include "incision/ros/robot_description.h"
#include "incision/ros/scene_parameter.h"

namespace incision {
namespace {

/// The folder of the scene's file, which the parameter of its text does not tell.
std::string sceneFolder(const YamlMap& parameters) {
  const auto folder = parameters.find("scene_folder");
  if (!folder) return "";
  const std::string address = folder->text(MAX_PATH);
  if (address.front() != '/' && address.find("://") == std::string::npos)
    folder->refuse("package://NAME/FOLDER or an absolute path");
  return folder->path();
}

Scene loadSceneParameter(const ros::NodeHandle& node, const std::string& folder) {
  const std::string name = node.resolveName("scene");
  XmlRpc::XmlRpcValue value;
  if (!node.getParam("scene", value))
    throw InputError(name + ": this parameter is missing; load a scene file there, as incision.launch does");
  Scene scene = parseScene(toYaml(value, name), name, folder);
  loadPoses(&scene);
  for (Clamp& clamp : scene.boundary)
    if (!clamp.frame.empty()) clamp.poses.clear();  // tf has them
  return scene;
}

}  // namespace

NodeSettings loadSettings(const ros::NodeHandle& node) {
  const YamlMap parameters =
      privateParameters(node, {"scene", "scene_folder", "tool_description", "obstacle_description", "marker_rate",
                               "marker_field", "transform_timeout", "max_lag"});
  NodeSettings settings;
  settings.scene = loadSceneParameter(node, sceneFolder(parameters));
  settings.descriptions = readDescriptions(node, &settings.scene);
  settings.marker_rate = parameters.number("marker_rate", settings.marker_rate, {0, 1000});
  if (const auto field = parameters.find("marker_field"))
    settings.marker_field = field->choice<MarkerField>(
        {{"none", MarkerField::NONE}, {"region", MarkerField::REGION}, {"stress", MarkerField::STRESS}});
  settings.transform_timeout = parameters.number("transform_timeout", settings.transform_timeout, {0, 60});
  settings.max_lag = parameters.number("max_lag", settings.max_lag, {MAX_CLOCK_ADVANCE, 1e6});
  return settings;
}

}  // namespace incision
