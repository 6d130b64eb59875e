// Files of other formats are refused by their names and with the command that makes a mesh of them.
#include <gtest/gtest.h>

#include <string>

#include "support/mesh_text.h"

namespace incision {
namespace {

TEST(ForeignFile, IsNamedWithTheCommandThatConvertsIt) {
  const std::string binary_stl = std::string(80, 'x') + std::string("\2\0\0\0", 4) + std::string(100, '\0');
  const std::string solid_binary_stl = "solid" + binary_stl.substr(5);
  struct Case {
    std::string text, what, command;
  };
  const std::vector<Case> cases = {
      {"$NOD\n1\n1 0 0 0\n$ENDNOD\n", "Gmsh's format 1", "gmsh in.msh -save -format msh22"},
      {"$MeshFormat\n4 0 8\n$EndMeshFormat\n", "another version", "gmsh in.msh -save -format msh22"},
      {"$MeshFormat\n2.2 1 8\n\1\0\0\0", "binary", "gmsh in.msh -save -format msh22"},
      {"solid a\n facet normal 0 0 1\n outer loop\n", "an STL file", "gmsh -3 -format msh22 stl_to_mesh.geo"},
      {binary_stl, "an STL file", "gmsh -3 -format msh22 stl_to_mesh.geo"},
      {solid_binary_stl, "an STL file", "gmsh -3 -format msh22 stl_to_mesh.geo"},
      {"# vtk DataFile Version 2.0\n", "a VTK file", "meshio convert"},
      {"<?xml version=\"1.0\"?>\n<VTKFile type=\"UnstructuredGrid\">\n", "a VTK file", "meshio convert"},
      {"<?xml version=\"1.0\"?>\n<!-- mine -->\n<robot xmlns:xacro=\"x\">\n", "XML", "stl_to_mesh.geo"},
      {"<?xml version=\"1.0\"?><COLLADA version=\"1.4.1\">", "a surface", "assimp export"},
      {"MeshVersionFormatted 2\n", "a Medit file", "gmsh in.mesh -save -format msh22"},
      {"version https://git-lfs.github.com/spec/v1\n", "Git LFS", "git lfs pull"},
      {"SetFactory(\"OpenCASCADE\");\n", "a script of Gmsh", "gmsh -3 -format msh22 in.geo"},
      {"just words\n", "text that does not begin", "meshio convert"},
      {std::string("\x7f"
                   "ELF\0\1\2",
                   7),
       "binary data that does not begin", "meshio convert"},
      {" \n\n", "the file is empty", "did gmsh report errors?"}};
  for (const auto& [text, what, command] : cases) {
    const std::string error = errorOf(text);
    EXPECT_EQ(error.find("a.msh:"), 0u) << error;
    EXPECT_NE(error.find(what), std::string::npos) << error;
    EXPECT_NE(error.find(command), std::string::npos) << error;
    EXPECT_EQ(error.find('\n'), std::string::npos) << error;
  }
}

}  // namespace
}  // namespace incision
