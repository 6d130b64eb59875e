#include "incision/mesh/rest_box.h"

#include <Eigen/Geometry>

#include "incision/base/yaml_reader.h"
#include "incision/mesh/tet_mesh.h"

namespace incision {

RestBox boundsOf(const TetMesh& mesh) {
  Eigen::AlignedBox3d box;
  for (const auto& element : mesh.elements)
    for (int n : element) box.extend(mesh.nodes[n]);
  return {box.min(), box.max()};
}

RestBox parseRestBox(const YamlValue& value) {
  const std::vector<YamlValue> ends = value.list(2);
  const RestBox box = {ends[0].vector(), ends[1].vector()};
  if ((box.min.array() > box.max.array()).any()) {
    value.fail("a lower corner above the upper (allowed: [[x, y, z], [X, Y, Z]] with x <= X, y <= Y, z <= Z)");
  }
  return box;
}

}  // namespace incision
