#include "foreign_file.h"

#include <algorithm>
#include <cstdint>
#include <cstring>

namespace incision {
namespace {

using std::string_view;

const std::string FROM_SURFACE =
    "copy stl_to_mesh.geo of this package beside it and run  gmsh -3 -format msh22 stl_to_mesh.geo -o out.msh";
const std::string BY_MESHIO = "meshio convert IN out.msh --output-format gmsh22 --ascii";

/// How a file of some format begins, after blanks.
struct Format {
  const char* beginning;
  std::string what;
};

const Format FORMATS[] = {
    {"$NOD", "a file of Gmsh's format 1: gmsh in.msh -save -format msh22 -o out.msh"},
    {"$PARA", "a file of Gmsh's format 1: gmsh in.msh -save -format msh22 -o out.msh"},
    {"# vtk DataFile", "a VTK file: " + BY_MESHIO},
    {"<VTKFile", "a VTK file: " + BY_MESHIO},
    {"MeshVersionFormatted", "a Medit file: gmsh in.mesh -save -format msh22 -o out.msh"},
    {"*Heading", "an Abaqus file: " + BY_MESHIO},
    {"*HEADING", "an Abaqus file: " + BY_MESHIO},
    {"OFF", "a surface, not a volume: gmsh in.off -save -format stl -o surface.stl, then " + FROM_SURFACE},
    {"ply", "a surface, not a volume: gmsh in.ply -save -format stl -o surface.stl, then " + FROM_SURFACE},
    {"<COLLADA", "a surface, not a volume: assimp export in.dae surface.stl, then " + FROM_SURFACE},
    {"version https://git-lfs", "a pointer of Git LFS, not the mesh: git lfs pull"},
    {"SetFactory", "a script of Gmsh: gmsh -3 -format msh22 in.geo -o out.msh"},
    {"//", "a script of Gmsh: gmsh -3 -format msh22 in.geo -o out.msh"},
};

bool begins(string_view text, string_view beginning) { return text.substr(0, beginning.size()) == beginning; }

/// What comes after blanks, and after XML's declaration and comments, which say nothing of the format.
string_view afterPreamble(string_view text) {
  const auto skip = [&](string_view end) {
    const std::size_t at = text.find(end);
    text.remove_prefix(at == string_view::npos ? text.size() : at + end.size());
  };
  while (true) {
    text.remove_prefix(std::min(text.find_first_not_of(" \t\r\n"), text.size()));
    if (begins(text, "<?"))
      skip("?>");
    else if (begins(text, "<!--"))
      skip("-->");
    else
      return text;
  }
}

/// Binary STL: 80 bytes of anything, the number of triangles, and 50 bytes for each.
bool isBinaryStl(string_view text) {
  constexpr std::size_t HEAD = 80, TRIANGLE = 50;
  std::uint32_t triangles = 0;
  if (text.size() < HEAD + sizeof triangles) return false;
  std::memcpy(&triangles, text.data() + HEAD, sizeof triangles);
  return text.size() == HEAD + sizeof triangles + TRIANGLE * std::size_t{triangles};
}

}  // namespace

std::string describeForeignFile(string_view text) {
  if (text.find_first_not_of(" \t\r\n") == string_view::npos) return "the file is empty: did gmsh report errors?";
  const string_view begin = afterPreamble(text);
  if (isBinaryStl(text) || (begins(begin, "solid") && begin.find("facet") != string_view::npos))
    return "an STL file, which is a surface, not a volume: " + FROM_SURFACE;
  for (const Format& format : FORMATS)
    if (begins(begin, format.beginning)) return format.what;
  if (begins(begin, "<") || begins(text, "<"))
    return "XML, as of a URDF or xacro file, not a mesh: of an STL file it names, " + FROM_SURFACE;
  if (begins(begin, "$")) return "";
  const bool binary = std::any_of(text.begin(), text.end(), [](char c) { return c == '\0'; });
  return std::string(binary ? "binary data" : "text") +
         " that does not begin as a Gmsh ASCII file, with $MeshFormat: from other formats of meshes, " + BY_MESHIO;
}

}  // namespace incision
