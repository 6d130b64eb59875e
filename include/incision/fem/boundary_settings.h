#pragma once

#include "incision/mesh/rest_box.h"

namespace incision {

/// Nodes whose rest position lies in the box move with a given velocity.
struct Clamp {
  RestBox box;
  Vec3 velocity = Vec3::Zero();  ///< [m/s]
};

/// A dead load on the boundary faces all of whose nodes lie in the box.
struct Load {
  RestBox box;
  Vec3 traction = Vec3::Zero();  ///< [Pa]
  double ramp = 0;               ///< time [s] from nothing to full; 0: at once
};

/// An entry of the section `boundary`. Throws InputError.
Clamp parseClamp(const YamlValue& value);

/// An entry of the section `loads`. Throws InputError.
Load parseLoad(const YamlValue& value);

}  // namespace incision
