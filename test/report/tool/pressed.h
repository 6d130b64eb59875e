#pragma once

#include <vector>

#include "incision/body/deformable_body.h"

namespace incision::report {

/// A body that lies on a table and is held where it does, and a blade that comes down on it from above. Its edge lies
/// along y and sticks out on both sides. The body's lowest point is at z = 0, its middle at x = y = 0.
struct Pressed {
  TetMesh mesh;
  double height = 0;       ///< of the body [m]
  double held = 0;         ///< of it, from below [m]
  Material material = {};  ///< its damping included
  double force = 0;        ///< F_c [N/m]
  double onset = 0;        ///< F_o [N/m]
  double speed = 0;        ///< of the blade [m/s]
  double stride = 0;       ///< of the blade in a step [m]
  double travel = 0;       ///< of the blade from where it meets the body [m]
  double beside = 0;       ///< how far off the body's middle it cuts [m]
};

/// What the blade feels, after each step.
struct Felt {
  std::vector<double> depth;  ///< below the body's top at rest [m]
  std::vector<double> force;  ///< upwards, on the blade [N]
  std::vector<double> area;   ///< that it has cut [m²]
};

Felt press(const Pressed& pressed);

/// A prism of these sides in cells of one size.
TetMesh prism(const Vec3& size, double cell);

/// A cylinder that lies along x.
TetMesh cylinder(double length, double diameter, double cell);

}  // namespace incision::report
