#pragma once

#include <ros/node_handle.h>

#include "incision/scene/scene.h"

namespace incision {

/// Texts of the URDFs: of all tools the parameter `tool_description`, looked for in the node's namespace and then
/// upwards as usual for descriptions, and without it the files that the scene names; of the obstacles likewise the
/// parameter `obstacle_description`, which then stands in the scene's contact section in place of the file; a scene
/// without that section gets one. Throws InputError when one cannot be read.
Descriptions readDescriptions(const ros::NodeHandle& node, Scene* scene);

}  // namespace incision
