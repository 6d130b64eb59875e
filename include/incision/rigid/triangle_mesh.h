#pragma once

#include <array>
#include <vector>

#include "incision/base/vec.h"

namespace incision {

/// Triangles as a file has them, in any order and of any orientation.
struct TriangleMesh {
  std::vector<Vec3> vertices;                 ///< [m]
  std::vector<std::array<int, 3>> triangles;  ///< vertices
};

}  // namespace incision
