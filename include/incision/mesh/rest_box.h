#pragma once

#include "incision/base/vec.h"

namespace incision {

struct TetMesh;
class YamlValue;

/// Axis-aligned, in rest coordinates [m], closed.
struct RestBox {
  Vec3 min = Vec3::Zero(), max = Vec3::Zero();
  bool contains(const Vec3& X) const { return (X.array() >= min.array()).all() && (X.array() <= max.array()).all(); }
};

/// Round the nodes that elements use, of which there are some.
RestBox boundsOf(const TetMesh& mesh);

/// Throws InputError.
RestBox parseRestBox(const YamlValue& value);

}  // namespace incision
