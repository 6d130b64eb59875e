#pragma once

#include <map>
#include <string>

#include "incision/mesh/tet_mesh.h"
#include "report/temporary_folder.h"

namespace incision::report {

/// Meshes by Gmsh, of the geometries beside this file.
class Gmsh {
 public:
  struct Made {
    TetMesh mesh;
    double ms;  ///< wall time that Gmsh took, reading its file included
  };

  /// The mesh for `cells`, with or without the crack on faces; made once. Throws std::runtime_error when Gmsh fails.
  const Made& mesh(const std::string& geometry, int cells, bool faces);

 private:
  TemporaryFolder folder_;
  std::map<std::string, Made> made_;  // by command
};

}  // namespace incision::report
