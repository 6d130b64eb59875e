#pragma once

#include <array>

#include "incision/base/vec.h"

namespace incision {

class YamlValue;

struct GridSettings {
  std::array<int, 3> cells = {1, 1, 1};  ///< along x, y, z; each ≥ 1
  Vec3 size = Vec3::Ones();              ///< of the whole grid [m]; each > 0
  Vec3 origin = Vec3::Zero();            ///< of the corner with the smallest coordinates [m]
};

/// Throws InputError. How many cells there may be in all is for gridMesh() to say.
GridSettings parseGrid(const YamlValue& value);

}  // namespace incision
