#pragma once

#include <filesystem>
#include <string>

#include "incision/mesh/tet_mesh.h"

namespace incision::report {

/// Meshes by Gmsh, of the geometries beside this file.
class Gmsh {
 public:
  Gmsh();
  ~Gmsh();
  Gmsh(const Gmsh&) = delete;

  /// The mesh for `cells`, with or without the crack on faces; `ms` is the wall time [ms] that Gmsh took, reading its
  /// file included. Throws InputError when Gmsh fails.
  TetMesh mesh(const std::string& geometry, int cells, bool faces, double* ms) const;

 private:
  std::filesystem::path folder_;  // of the mesh files, of this object's own
};

}  // namespace incision::report
