#include "incision/ros/private_parameters.h"

#include "incision/base/limits.h"
#include "incision/ros/scene_parameter.h"

namespace incision {

YamlMap privateParameters(const ros::NodeHandle& node, const std::vector<std::string>& allowed) {
  const std::string& name = node.getNamespace();
  XmlRpc::XmlRpcValue value;
  const YAML::Node all = node.getParam(name, value) ? toYaml(value, name) : YAML::Node();
  return YamlValue(all, name).map(allowed);
}

std::string frameParameter(const YamlMap& parameters, const std::string& key, const std::string& absent) {
  const auto value = parameters.find(key);
  return value ? value->frame() : absent;
}

Pose toPose(const YamlValue& value) {
  const std::vector<YamlValue> numbers = value.list(6);
  const auto number = [&](std::size_t i) { return numbers[i].number({-MAX_COORDINATE, MAX_COORDINATE}); };
  const auto turn = [&](std::size_t i, const Vec3& axis) { return Eigen::AngleAxisd(number(i), axis); };
  Pose pose;
  pose.position = {number(0), number(1), number(2)};
  pose.orientation = turn(5, Vec3::UnitZ()) * turn(4, Vec3::UnitY()) * turn(3, Vec3::UnitX());
  return pose;
}

}  // namespace incision
