#include "report/locking/problem.h"

#include <fstream>

#include "incision/mesh/mesh_io.h"
#include "report/temporary_folder.h"
#include "support/rig.h"

namespace incision::report {
namespace {

/// Edge of a tetrahedron in units of the edge of a cell, such that as many fill the box.
constexpr double EDGE_OF_CELL = 1.1;

}  // namespace

TetMesh Problem::grid(int refinement) const {
  return gridMesh({{refinement * cells[0], refinement * cells[1], refinement * cells[2]}, size, origin});
}

TetMesh Problem::unstructured(int refinement) const {
  const TemporaryFolder folder;
  std::ofstream geometry(folder.file("box.geo"));
  geometry << "SetFactory(\"OpenCASCADE\");\nBox(1) = {" << origin.x() << ',' << origin.y() << ',' << origin.z() << ','
           << size.x() << ',' << size.y() << ',' << size.z() << "};\n";
  if (name == pressedBlock().name)
    geometry << "Rectangle(20) = {-0.25, -0.25, 0.5, 0.5, 0.5};\n"
             << "BooleanFragments{Volume{1}; Delete;}{Surface{20}; Delete;}\n";
  const double edge = EDGE_OF_CELL * size.x() / (refinement * cells[0]);
  geometry << "Mesh.MeshSizeMin = " << edge << ";\nMesh.MeshSizeMax = " << edge << ";\n";
  geometry.close();
  folder.run("gmsh -3 -format msh22 " + folder.file("box.geo") + " -o " + folder.file("box.msh"));
  return readGmsh(folder.file("box.msh"));
}

Problem cantilever() {
  Problem p{"cantilever", Vec3(1, 0.25, 0.25), Vec3(0, -0.125, 0), {8, 2, 2}, {}, {}};
  p.clamps = {{slab(0, 0), Vec3::Zero()}};
  p.loads = {{slab(0, 1), Vec3(0, 0, -10), 0}};
  return p;
}

Problem heldBlock() {
  Problem p{"held block", Vec3(1, 1, 0.5), Vec3(-0.5, -0.5, 0), {4, 4, 2}, {}, {}};
  p.clamps = {{slab(2, 0), Vec3::Zero()}, {slab(2, 0.5), Vec3(0, 0, -0.005)}};
  return p;
}

Problem pressedBlock() {
  Problem p{"pressed block", Vec3(1, 1, 0.5), Vec3(-0.5, -0.5, 0), {4, 4, 2}, {}, {}};
  p.clamps = {{slab(2, 0), Vec3::Zero()}};
  const double half = 0.25 + 1e-9;
  p.loads = {{{Vec3(-half, -half, 0.5 - 1e-9), Vec3(half, half, 1)}, Vec3(0, 0, -1000), 0}};
  return p;
}

}  // namespace incision::report
