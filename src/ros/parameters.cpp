#include "incision/ros/parameters.h"

#include <yaml-cpp/yaml.h>

#include "incision/base/input_error.h"
#include "incision/pace/clamp_tracker.h"
#include "incision/pace/pacer.h"
#include "incision/ros/private_parameters.h"
#include "incision/ros/robot_description.h"
#include "incision/ros/scene_parameter.h"
#include "incision/run/checkpoints.h"

namespace incision {
namespace {

/// Shorter periods [s] would keep a disk busy.
constexpr double LEAST_AUTOSAVE = 0.1;

/// A folder from a package, or with its whole path: the node does not know from where somebody names one. Without the
/// parameter an empty one.
std::string folderParameter(const YamlMap& parameters, const std::string& name) {
  const auto folder = parameters.find(name);
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
  leaveClampsToFrames(&scene);
  return scene;
}

void loadCheckpointSettings(const YamlMap& parameters, NodeSettings* settings) {
  settings->checkpoint_folder = folderParameter(parameters, "checkpoint_folder");
  if (const auto autosave = parameters.find("autosave")) {
    settings->autosave = parameters.number("autosave", 0, {0, 1e6});
    if (settings->autosave > 0 && settings->autosave < LEAST_AUTOSAVE) autosave->refuse("0, or from 0.1 to 1e6");
    if (settings->autosave > 0 && settings->checkpoint_folder.empty())
      autosave->refuse("0 without a checkpoint_folder, where it would save");
  }
  if (const auto restore = parameters.find("restore")) {
    settings->restore = restore->text(MAX_CHECKPOINT_NAME);
    if (settings->checkpoint_folder.empty()) restore->refuse("nothing without a checkpoint_folder, where it would be");
  }
}

}  // namespace

NodeSettings loadSettings(const ros::NodeHandle& node) {
  const YamlMap parameters = privateParameters(
      node, {"scene", "scene_folder", "tool_description", "obstacle_description", "marker_rate", "marker_field",
             "transform_timeout", "max_lag", "diagnostic_period", "checkpoint_folder", "autosave", "restore"});
  NodeSettings settings;
  settings.scene = loadSceneParameter(node, folderParameter(parameters, "scene_folder"));
  settings.descriptions = readDescriptions(node, &settings.scene);
  settings.markers = parseMarkers(parameters, settings.markers);
  settings.transform_timeout = parameters.number("transform_timeout", settings.transform_timeout, {0, 60});
  settings.max_lag = parameters.number("max_lag", settings.max_lag, {MAX_CLOCK_ADVANCE, 1e6});
  settings.diagnostic_period = parameters.number("diagnostic_period", settings.diagnostic_period, {0.1, 60});
  loadCheckpointSettings(parameters, &settings);
  return settings;
}

}  // namespace incision
