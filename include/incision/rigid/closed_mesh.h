#pragma once

#include <string>
#include <vector>

#include "incision/rigid/triangle_mesh.h"

namespace incision {

/// Closed surfaces, each of which bounds a solid. Every edge has two triangles and every vertex one ring of them: where
/// more meet in the file, vertices are there several times.
struct ClosedMesh {
  std::vector<Vec3> vertices;                  ///< [m]
  std::vector<std::array<int, 3>> triangles;   ///< vertices, counterclockwise as seen from outside; by shell
  std::vector<std::array<int, 3>> neighbours;  ///< of each triangle, across its edge from corner k to corner k + 1
  std::vector<int> shell_start;  ///< triangles of shell s: from shell_start[s] to before shell_start[s + 1]

  int shells() const { return static_cast<int>(shell_start.size()) - 1; }
};

/// As a share of a mesh's extent, how near vertices are to be one, and how thin is nothing: a file's numbers, which are
/// often floats or of seven digits, differ by a tenth of it.
inline constexpr double ALIKE = 1e-6;

/// Most shells of a mesh, each of which is looked at for every point that is near: a machine's housing with all its
/// screws has a tenth of it.
inline constexpr int MAX_SHELLS = 1000;

/// The closed surfaces of a mesh. Vertices that are ALIKE are one; triangles are turned outwards, a cavity too, so that
/// it is filled; what is there twice counts once; sheets that enclose nothing are left out; a hole is closed by
/// triangles round the mean of its rim. What was mended is said in `remark`, empty where nothing was. Throws
/// InputError, in words that go on after the mesh's name, when that leaves no solid, too many or something that has no
/// outside.
ClosedMesh closeMesh(const TriangleMesh& mesh, std::string* remark);

}  // namespace incision
