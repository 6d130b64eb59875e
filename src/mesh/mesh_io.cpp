#include "incision/mesh/mesh_io.h"

#include <cerrno>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <istream>
#include <string>
#include <system_error>

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

TetMesh readGmsh(std::istream& in, const std::string& name, MeshRepairs* repairs) {
  const std::string text = readAll(in, name);
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
