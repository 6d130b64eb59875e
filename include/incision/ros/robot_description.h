#pragma once

#include <ros/node_handle.h>

#include <string>

#include "incision/scene/scene.h"

namespace incision {

/// Text of the tool's URDF: the parameter `tool_description`, looked for in the node's namespace and then upwards as
/// usual for descriptions; without it the file that the scene names; empty when the scene needs neither. Throws
/// InputError when it cannot be read.
std::string toolDescription(const ros::NodeHandle& node, const Scene& scene);

/// Text of the obstacles' URDF: the parameter `obstacle_description`, looked for and read in that way, which then
/// stands in the scene's contact section in place of the file; a scene without that section gets one.
std::string obstacleDescription(const ros::NodeHandle& node, Scene* scene);

}  // namespace incision
