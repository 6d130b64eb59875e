#pragma once

#include <ros/node_handle.h>

#include <string>

#include "incision/body/scene.h"

namespace incision {

/// Text of the tool's URDF: the parameter `tool_description`, looked for in the node's namespace and then upwards as
/// usual for descriptions; without it the file that the scene names; empty when the scene needs neither. Throws
/// InputError when it cannot be read.
std::string toolDescription(const ros::NodeHandle& node, const Scene& scene);

}  // namespace incision
