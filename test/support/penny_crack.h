#pragma once

#include <algorithm>
#include <cmath>
#include <vector>

#include "incision/cut/section.h"
#include "support/rig.h"

namespace incision {

/// Half the width [m] of a block with its centre at the origin, round a disc-shaped crack of about 1 m.
inline constexpr double BLOCK_HALF = 4;

/// Half the width [m] of the block's fine region, and its share of the cells.
inline constexpr double FINE_HALF = 1.3, FINE_SHARE = 0.7;

/// The block; most of its cells lie round the crack.
inline TetMesh gradedBlock(int cells) {
  TetMesh mesh = block({cells, cells, cells}, Vec3::Constant(2), Vec3::Constant(-1));
  for (Vec3& X : mesh.nodes)
    for (double& s : X) {
      const double beyond = std::max(0.0, (std::abs(s) - FINE_SHARE) / (1 - FINE_SHARE));
      s = std::copysign(
          FINE_HALF * std::min(std::abs(s) / FINE_SHARE, 1.0) + (BLOCK_HALF - FINE_HALF) * std::pow(beyond, 1.5), s);
    }
  return mesh;
}

/// The disc z = 0, r < radius, of copies at `x`.
inline CrackField disc(double radius, const CutMesh& mesh, const std::vector<Vec3>& x) {
  CrackField field = planeField(plane(Vec3::Zero(), Vec3::UnitZ()), mesh, x);
  field.contains = [&mesh, &x, radius](int part, const std::vector<Barycentric>& polygon) {
    return at(mesh.parts()[part], polygonCentroid(polygon), x).head<2>().norm() < radius;
  };
  return field;
}

}  // namespace incision
