#include "incision/mesh/mesh_io.h"

#include <cerrno>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <istream>
#include <string>
#include <system_error>

#include "foreign_file.h"
#include "gmsh_reader.h"
#include "incision/base/input_error.h"
#include "incision/base/line_reader.h"
#include "mesh_builder.h"

namespace incision {
namespace {

/// Largest file [bytes]: some 15 million tetrahedra. No count in a file can then pass an int, and a device or an
/// endless stream given by mistake ends in an error instead of filling the memory.
constexpr std::size_t MAX_FILE_BYTES = std::size_t{1} << 30;

std::string readAll(std::istream& in, const std::string& name) {
  constexpr std::size_t CHUNK_BYTES = std::size_t{1} << 16;
  std::string text;
  do {
    const std::size_t size = text.size();
    text.resize(size + CHUNK_BYTES);
    in.read(&text[size], CHUNK_BYTES);
    text.resize(size + static_cast<std::size_t>(in.gcount()));
    if (text.size() > MAX_FILE_BYTES)
      throw InputError(name + ": larger than " + std::to_string(MAX_FILE_BYTES >> 20) + " MiB, the most that is read");
  } while (in);
  if (in.bad()) throw InputError(name + ": cannot be read to its end");
  return text;
}

}  // namespace

std::vector<std::string> sentences(const MeshRepairs& repairs) {
  std::vector<std::string> all;
  const auto say = [&](int count, const std::string& what, const std::string& hint = "") {
    if (count > 0) all.push_back(what + ": " + std::to_string(count) + hint);
  };
  say(repairs.reoriented, "elements of negative volume, of which two nodes were swapped");
  say(repairs.second_order_elements, "elements of ten nodes, of which the four corners are used");
  say(repairs.repeated_elements,
      "elements that repeat others, as a file has one for each of its physical groups, and so count as one in all of "
      "them");
  say(repairs.unreferenced_nodes, "nodes that are the corner of no tetrahedron, and are left out, of groups too");
  say(repairs.coincident_nodes, "nodes that lie at one place with a node of a part that is not joined to theirs",
      ", the first of them node " + std::to_string(repairs.coincident_pair[1]) + ", at node " +
          std::to_string(repairs.coincident_pair[0]) +
          "; if the parts should be one, put  Merge \"in.msh\"; Coherence Mesh;  into join.geo and run  gmsh join.geo "
          "-save -format msh22 -o out.msh");
  return all;
}

TetMesh readGmsh(std::istream& in, const std::string& name, MeshRepairs* repairs) {
  const std::string text = readAll(in, name);
  const std::string foreign = describeForeignFile(text);
  if (!foreign.empty()) throw InputError(name + ":1: " + foreign);
  LineReader reader(text, name);
  MeshBuilder builder(reader);
  readGmshSections(reader, builder);
  MeshRepairs repaired;
  TetMesh mesh = builder.finish(repaired);
  if (repairs) *repairs = repaired;
  return mesh;
}

TetMesh readGmsh(const std::string& path, MeshRepairs* repairs) {
  std::error_code ignored;
  if (std::filesystem::is_directory(path, ignored)) throw InputError(path + ": a directory, not a mesh file");
  std::ifstream in(path, std::ios::binary);
  if (!in) throw InputError(path + ": cannot be opened: " + std::strerror(errno));
  return readGmsh(in, path, repairs);
}

}  // namespace incision
