#include "incision/mesh/grid_settings.h"

#include <limits>

#include "incision/base/yaml_reader.h"

namespace incision {

GridSettings parseGrid(const YamlValue& value) {
  const YamlMap map = value.map({"cells", "size", "origin"});
  GridSettings grid;
  const std::vector<YamlValue> cells = map.at("cells").list(3);
  for (std::size_t axis = 0; axis < 3; ++axis) {
    grid.cells[axis] = cells[axis].integer(1, std::numeric_limits<int>::max());
  }
  if (map.has("size")) grid.size = map.at("size").vector(POSITIVE);
  grid.origin = map.vector("origin", grid.origin);
  return grid;
}

}  // namespace incision
