#pragma once

#include <optional>
#include <string>

namespace incision {

struct ContactSettings {
  std::optional<double> ground;  ///< height [m] of the ground, which fills all that lies below; absent: none
  std::string obstacles;         ///< URDF file, or the parameter that holds its text; empty: none
  double friction = 0.3;         ///< Coulomb's coefficient
  bool self = true;              ///< the body's pieces also touch each other
};

}  // namespace incision
