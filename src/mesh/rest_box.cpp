#include "incision/mesh/rest_box.h"

#include "incision/base/yaml_reader.h"

namespace incision {

RestBox parseRestBox(const YamlValue& value) {
  const std::vector<YamlValue> ends = value.list(2);
  const RestBox box = {ends[0].vector(), ends[1].vector()};
  if ((box.min.array() > box.max.array()).any()) {
    value.fail("a lower corner above the upper (allowed: [[x, y, z], [X, Y, Z]] with x <= X, y <= Y, z <= Z)");
  }
  return box;
}

}  // namespace incision
