#include "gmsh_reader.h"

#include <algorithm>
#include <string>
#include <vector>

#include "gmsh_elements.h"
#include "gmsh_groups.h"
#include "gmsh_sections.h"

namespace incision {
namespace {

enum class Version { V2_2, V4_1 };

// The least bytes an item takes, line ends included: they bound the counts by the size of the file.
constexpr int NODE_BYTES = 8;     // "1 0 0 0" in version 2.2, "1" and "0 0 0" in 4.1
constexpr int ELEMENT_BYTES = 4;  // "1 1"
constexpr int BLOCK_BYTES = 8;    // "0 1 0 0"

const std::string CONVERT = "gmsh in.msh -save -format msh22 -o out.msh";

Version readFormat(LineReader& reader) {
  nextRecord(reader, "$MeshFormat");
  const double version = reader.real("version");
  const std::int64_t file_type = reader.integer("file type", 0);
  if (version != 2.2 && version != 4.1)
    reader.fail("this is another version of the Gmsh format; 2.2 and 4.1 can be read: " + CONVERT);
  if (file_type != 0) reader.fail("the file is binary; only ASCII files (file type 0) can be read: " + CONVERT);
  reader.integer("data size", 1);
  reader.endOfLine();
  return version == 2.2 ? Version::V2_2 : Version::V4_1;
}

Vec3 readPosition(LineReader& reader) {
  const double x = reader.real("x");
  const double y = reader.real("y");
  const double z = reader.real("z");
  return {x, y, z};
}

/// The kind of the elements of a type, which must be such as can be told from what they are not.
const GmshElement& readElementKind(LineReader& reader) {
  const std::int64_t type = reader.integer("element type", 1);
  const GmshElement* kind = findGmshElement(type);
  if (!kind)
    reader.fail("element type " + std::to_string(type) +
                " is none that can be read: mesh the geometry again with gmsh -3 -order 1");
  if (kind->isTetrahedron() && kind->order > 2)
    reader.fail("tetrahedra of " + std::to_string(kind->nodes) + " nodes (element type " + std::to_string(type) +
                "); those of 4 and 10 can be read: mesh the geometry again with gmsh -3 -order 1");
  return *kind;
}

/// The rest of an element's line, which are its nodes. `nodes` is scratch.
void readElement(LineReader& reader, MeshBuilder& builder, const GmshElement& kind, std::int64_t number,
                 const std::vector<int>& groups, std::vector<std::int64_t>& nodes) {
  if (kind.dimension < 3) builder.skipElement();
  if (kind.dimension < 3 && groups.empty()) return;
  if (kind.dimension == 3 && !kind.isTetrahedron()) return builder.addOtherVolume(kind);
  nodes.resize(kind.nodes);
  for (auto& node : nodes) node = reader.integer("node", 1);
  reader.endOfLine();
  if (kind.isTetrahedron())
    builder.addTetrahedron(number, nodes, groups);
  else
    builder.addToGroups(kind, number, nodes, groups);
}

void readNodes22(LineReader& reader, MeshBuilder& builder) {
  nextRecord(reader, "$Nodes");
  const int count = reader.count("number of nodes", 0, NODE_BYTES);
  reader.endOfLine();
  builder.reserveNodes(count);
  for (int i = 0; i < count; ++i) {
    nextRecord(reader, "$Nodes");
    const std::int64_t tag = reader.integer("node", 1);
    const Vec3 position = readPosition(reader);
    reader.endOfLine();
    builder.addNode(tag, position);
  }
}

void readElements22(LineReader& reader, MeshBuilder& builder) {
  nextRecord(reader, "$Elements");
  const int count = reader.count("number of elements", 0, ELEMENT_BYTES);
  reader.endOfLine();
  builder.reserveElements(count);
  std::vector<int> groups;
  std::vector<std::int64_t> nodes;
  for (int i = 0; i < count; ++i) {
    nextRecord(reader, "$Elements");
    const std::int64_t number = reader.integer("element", 1);
    const GmshElement& kind = readElementKind(reader);
    const std::int64_t tags = reader.integer("number of tags", 0);
    groups.clear();
    for (std::int64_t k = 0; k < tags; ++k) {
      if (k > 0)
        reader.integer("tag", INT64_MIN);
      else if (const int group = readGroupNumber(reader))
        groups.push_back(group);
    }
    readElement(reader, builder, kind, number, groups, nodes);
  }
}

/// Head of $Nodes or $Elements in version 4.1: blocks, items in all, smallest and largest number.
struct Head {
  int blocks, items;
};

Head readHead41(LineReader& reader, const std::string& section, int item_bytes) {
  nextRecord(reader, section);
  const int blocks = reader.count("number of blocks", 0, BLOCK_BYTES);
  const int items = reader.count("number of items", 0, item_bytes);
  reader.integer("smallest number", 0);
  reader.integer("largest number", 0);
  reader.endOfLine();
  return {blocks, items};
}

/// Number of items in a block, none of which may go beyond those that the section's head announced.
int readBlockCount41(LineReader& reader, int items_left) {
  const std::int64_t count = reader.integer("items in the block", 0);
  reader.endOfLine();
  if (count > items_left)
    reader.fail("the block has " + std::to_string(count) + " items, but only " + std::to_string(items_left) +
                " are left of those announced");
  return static_cast<int>(count);
}

void readNodes41(LineReader& reader, MeshBuilder& builder) {
  auto [blocks, nodes_left] = readHead41(reader, "$Nodes", NODE_BYTES);
  builder.reserveNodes(nodes_left);
  std::vector<std::int64_t> tags;
  for (int b = 0; b < blocks; ++b) {
    nextRecord(reader, "$Nodes");
    const std::int64_t dimension = reader.integer("dimension of the entity", 0);
    reader.integer("entity", INT64_MIN);
    const std::int64_t parametric = reader.integer("parametric", 0);
    if (dimension > 3) reader.fail("dimension of the entity: must be 0, 1, 2 or 3");
    if (parametric > 1) reader.fail("parametric: must be 0 or 1");
    tags.resize(readBlockCount41(reader, nodes_left));
    nodes_left -= static_cast<int>(tags.size());

    for (std::int64_t& tag : tags) {
      nextRecord(reader, "$Nodes");
      tag = reader.integer("node", 1);
      reader.endOfLine();
    }
    for (std::int64_t tag : tags) {
      nextRecord(reader, "$Nodes");
      const Vec3 position = readPosition(reader);
      for (std::int64_t k = 0; k < parametric * dimension; ++k) reader.real("parametric coordinate");
      reader.endOfLine();
      builder.addNode(tag, position);
    }
  }
  if (nodes_left > 0) reader.fail(std::to_string(nodes_left) + " of the nodes announced are missing");
}

void readElements41(LineReader& reader, const GmshEntities& entities, MeshBuilder& builder) {
  auto [blocks, elements_left] = readHead41(reader, "$Elements", ELEMENT_BYTES);
  builder.reserveElements(elements_left);
  std::vector<std::int64_t> nodes;
  for (int b = 0; b < blocks; ++b) {
    nextRecord(reader, "$Elements");
    const std::int64_t dimension = reader.integer("dimension of the entity", 0);
    const std::int64_t entity = reader.integer("entity", INT64_MIN);
    const GmshElement& kind = readElementKind(reader);
    if (kind.dimension != dimension)
      reader.fail("dimension of the entity: " + std::to_string(dimension) + ", but its elements are " + kind.shape);
    const std::vector<int>& groups = entities.groupsOf(kind.dimension, entity);
    const int count = readBlockCount41(reader, elements_left);
    elements_left -= count;
    for (int i = 0; i < count; ++i) {
      nextRecord(reader, "$Elements");
      readElement(reader, builder, kind, reader.integer("element", 1), groups, nodes);
    }
  }
  if (elements_left > 0) reader.fail(std::to_string(elements_left) + " of the elements announced are missing");
}

}  // namespace

void readGmshSections(LineReader& reader, MeshBuilder& builder) {
  const std::vector<std::string> needed = {"$MeshFormat", "$Nodes", "$Elements"};
  const std::string order = ": $MeshFormat, $PhysicalNames, $Entities, $Nodes and $Elements must come once each";
  std::vector<std::string> seen;
  std::size_t done = 0;
  Version version = Version::V2_2;
  GmshEntities entities;
  while (reader.next()) {
    const std::string section(reader.rest());
    if (section.front() != '$')
      reader.fail("expected a section of a Gmsh ASCII file, such as " +
                  (done < needed.size() ? needed[done] : "$Comments") + ", not " + quoted(section));
    const bool is_needed = std::find(needed.begin(), needed.end(), section) != needed.end();
    const bool has_groups = section == "$PhysicalNames" || (section == "$Entities" && version == Version::V4_1);
    if (!is_needed && !has_groups) {
      skipSection(reader, section);
      continue;
    }
    const bool late =
        is_needed ? done == needed.size() || section != needed[done] : section == "$Entities" && done == needed.size();
    if (late || std::find(seen.begin(), seen.end(), section) != seen.end())
      reader.fail(section + " is given twice or out of order" + order);
    seen.push_back(section);
    if (is_needed) ++done;

    if (section == "$MeshFormat")
      version = readFormat(reader);
    else if (section == "$PhysicalNames")
      readPhysicalNames(reader, builder);
    else if (section == "$Entities")
      entities.read(reader);
    else if (section == "$Nodes")
      version == Version::V2_2 ? readNodes22(reader, builder) : readNodes41(reader, builder);
    else
      version == Version::V2_2 ? readElements22(reader, builder) : readElements41(reader, entities, builder);
    endSection(reader, section);
  }
  if (done < needed.size()) reader.fail("the file ends without a section " + needed[done]);
}

}  // namespace incision
