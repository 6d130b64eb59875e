#pragma once

#include <XmlRpcValue.h>

#include <string>

namespace YAML {
class Node;
}

namespace incision {

/// The YAML that a parameter was loaded from, but for spelling. `name` is what errors call it. Throws InputError for
/// the types that YAML has no word for: binary data and dates.
YAML::Node toYaml(const XmlRpc::XmlRpcValue& value, const std::string& name);

}  // namespace incision
