#pragma once

#include <ros/node_handle.h>

#include <string>
#include <vector>

#include "incision/base/yaml_reader.h"
#include "incision/rigid/pose.h"

namespace incision {

/// The parameters in the node's private namespace, read with the same checks and messages as a scene's keys. Throws
/// InputError at a parameter that is not among `allowed`.
YamlMap privateParameters(const ros::NodeHandle& node, const std::vector<std::string>& allowed);

/// A frame's name, without a leading slash; or `absent`.
std::string frameParameter(const YamlMap& parameters, const std::string& key, const std::string& absent);

/// A pose from [x, y, z, roll, pitch, yaw] in m and rad: turned about the fixed x, then y, then z axis, as in a URDF.
Pose toPose(const YamlValue& value);

}  // namespace incision
