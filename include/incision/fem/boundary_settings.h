#pragma once

#include "incision/mesh/place.h"

namespace incision {

/// The nodes of a place move with a given velocity.
struct Clamp {
  Place place;
  Vec3 velocity = Vec3::Zero();  ///< [m/s]
};

/// A dead load on the boundary faces of a place.
struct Load {
  Place place;
  Vec3 traction = Vec3::Zero();  ///< [Pa]
  double ramp = 0;               ///< time [s] from nothing to full; 0: at once
};

/// An entry of the section `boundary`. Throws InputError.
Clamp parseClamp(const YamlValue& value);

/// An entry of the section `loads`. Throws InputError.
Load parseLoad(const YamlValue& value);

}  // namespace incision
