#pragma once

#include <cstdint>
#include <map>
#include <utility>
#include <vector>

#include "incision/base/line_reader.h"
#include "mesh_builder.h"

namespace incision {

/// Takes the next word as the number of a physical group. A sign is the orientation of the elements, and dropped. 0
/// where the element or entity is in none.
int readGroupNumber(LineReader& reader);

/// $PhysicalNames, of versions 2.2 and 4.1: dimension, number and name in quotes.
void readPhysicalNames(LineReader& reader, MeshBuilder& builder);

/// The physical groups of the entities of a file of version 4.1, to which the blocks of its elements refer.
class GmshEntities {
 public:
  void read(LineReader& reader);

  /// Numbers of the groups; none for an entity that the file has not described.
  const std::vector<int>& groupsOf(int dimension, std::int64_t entity) const;

 private:
  void readEntity(LineReader& reader, int dimension);

  std::map<std::pair<int, std::int64_t>, std::vector<int>> groups_;  // where an entity is in some
  const std::vector<int> none_ = {};
};

}  // namespace incision
