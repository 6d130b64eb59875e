#include "incision/ros/scene_parameter.h"

#include <yaml-cpp/yaml.h>

#include "incision/base/input_error.h"

namespace incision {
namespace {

using XmlRpc::XmlRpcValue;

YAML::Node toMap(XmlRpcValue& value, const std::string& name) {
  YAML::Node map(YAML::NodeType::Map);
  for (auto& [key, member] : value) map[key] = toYaml(member, name + "/" + key);
  return map;
}

YAML::Node toSequence(XmlRpcValue& value, const std::string& name) {
  YAML::Node sequence(YAML::NodeType::Sequence);
  for (int i = 0; i < value.size(); ++i) sequence.push_back(toYaml(value[i], name + "[" + std::to_string(i) + "]"));
  return sequence;
}

}  // namespace

YAML::Node toYaml(const XmlRpcValue& value, const std::string& name) {
  XmlRpcValue v = value;  // its conversions are not const
  switch (v.getType()) {
    case XmlRpcValue::TypeBoolean:
      return YAML::Node(static_cast<bool>(v));
    case XmlRpcValue::TypeInt:
      return YAML::Node(static_cast<int>(v));
    case XmlRpcValue::TypeDouble:
      return YAML::Node(static_cast<double>(v));
    case XmlRpcValue::TypeString:
      return YAML::Node(static_cast<std::string>(v));
    case XmlRpcValue::TypeArray:
      return toSequence(v, name);
    case XmlRpcValue::TypeStruct:
      return toMap(v, name);
    default:
      throw InputError(name + ": binary data or a date; a scene holds numbers, texts, lists and maps");
  }
}

}  // namespace incision
