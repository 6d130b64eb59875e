#pragma once

#include "incision/base/vec.h"

namespace incision {

class YamlValue;

/// Axis-aligned, in rest coordinates [m], closed.
struct RestBox {
  Vec3 min = Vec3::Zero(), max = Vec3::Zero();
  bool contains(const Vec3& X) const { return (X.array() >= min.array()).all() && (X.array() <= max.array()).all(); }
};

/// Throws InputError.
RestBox parseRestBox(const YamlValue& value);

}  // namespace incision
