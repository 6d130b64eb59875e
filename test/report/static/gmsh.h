#pragma once

#include <filesystem>
#include <map>
#include <string>

#include "incision/mesh/tet_mesh.h"

namespace incision::report {

/// Meshes by Gmsh, of the geometries beside this file.
class Gmsh {
 public:
  Gmsh();
  ~Gmsh();
  Gmsh(const Gmsh&) = delete;

  struct Made {
    TetMesh mesh;
    double ms;  ///< wall time that Gmsh took, reading its file included
  };

  /// The mesh for `cells`, with or without the crack on faces; made once. Throws InputError when Gmsh fails.
  const Made& mesh(const std::string& geometry, int cells, bool faces);

 private:
  std::filesystem::path folder_;      // of the mesh file, of this object's own
  std::map<std::string, Made> made_;  // by command
};

}  // namespace incision::report
