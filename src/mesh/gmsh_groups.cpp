#include "gmsh_groups.h"

#include <cstdlib>
#include <limits>
#include <string>
#include <string_view>

#include "gmsh_sections.h"

namespace incision {
namespace {

constexpr std::int64_t MAX_NUMBER = std::numeric_limits<int>::max();

// The least bytes that a line takes, line end included: they bound the counts by the size of the file.
constexpr int NAME_BYTES = 7;     // "3 1 \"\""
constexpr int ENTITY_BYTES = 10;  // "1 0 0 0 0", a point
constexpr int NUMBER_BYTES = 1;   // "1" at the end of a line

/// The rest of the line, which is a text in quotes. Gmsh escapes none that the text may hold.
std::string readName(LineReader& reader) {
  const std::string_view text = reader.rest();
  if (text.size() < 2 || text.front() != '"' || text.back() != '"')
    reader.fail("the name of the physical group must be in quotes: " + quoted(text));
  return std::string(text.substr(1, text.size() - 2));
}

}  // namespace

int readGroupNumber(LineReader& reader) {
  const std::int64_t number = reader.integer("physical group", -MAX_NUMBER);
  if (number > MAX_NUMBER) reader.fail("physical group: must be at most " + std::to_string(MAX_NUMBER));
  return static_cast<int>(std::abs(number));
}

void readPhysicalNames(LineReader& reader, MeshBuilder& builder) {
  nextRecord(reader, "$PhysicalNames");
  const int count = reader.count("number of names", 0, NAME_BYTES);
  reader.endOfLine();
  for (int i = 0; i < count; ++i) {
    nextRecord(reader, "$PhysicalNames");
    const std::int64_t dimension = reader.integer("dimension", 0);
    if (dimension > 3) reader.fail("dimension: must be 0, 1, 2 or 3");
    const int number = readGroupNumber(reader);
    const std::string name = readName(reader);
    // Number 0 is no group, and one without a name goes by its number.
    if (number > 0 && !name.empty()) builder.nameGroup(static_cast<int>(dimension), number, name);
  }
}

void GmshEntities::read(LineReader& reader) {
  nextRecord(reader, "$Entities");
  int count[4];
  for (int& entities : count) entities = reader.count("number of entities", 0, ENTITY_BYTES);
  reader.endOfLine();
  for (int dimension = 0; dimension < 4; ++dimension)
    for (int i = 0; i < count[dimension]; ++i) readEntity(reader, dimension);
}

void GmshEntities::readEntity(LineReader& reader, int dimension) {
  nextRecord(reader, "$Entities");
  const std::int64_t entity = reader.integer("entity", INT64_MIN);
  // The position of a point, or the box of another entity, which Gmsh may write as numbers beyond those of a double.
  for (int i = 0; i < (dimension == 0 ? 3 : 6); ++i) reader.skip("coordinate");
  const int count = reader.count("number of physical groups", 0, NUMBER_BYTES);
  for (int i = 0; i < count; ++i)
    if (const int number = readGroupNumber(reader)) groups_[{dimension, entity}].push_back(number);
  // What follows is the entity's boundary.
}

const std::vector<int>& GmshEntities::groupsOf(int dimension, std::int64_t entity) const {
  const auto found = groups_.find({dimension, entity});
  return found == groups_.end() ? none_ : found->second;
}

}  // namespace incision
