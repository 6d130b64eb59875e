#pragma once

#include <optional>
#include <string>

namespace incision {

class YamlValue;

struct ContactSettings {
  std::optional<double> ground;  ///< height [m] of the ground, which fills all that lies below; absent: none
  std::string obstacles;         ///< URDF file, or the parameter that holds its text; empty: none
  double friction = 0.3;         ///< Coulomb's coefficient, in FRICTION
  bool self = true;              ///< the body's pieces also touch each other
};

/// The section `contact`. Throws InputError.
ContactSettings parseContact(const YamlValue& value);

}  // namespace incision
