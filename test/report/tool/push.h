#pragma once

#include <vector>

#include "incision/body/deformable_body.h"

namespace incision::report {

/// A block with its face x = 0 towards a blade, and held at its far end. The blade's edge lies along z and sticks out
/// on both sides; it is pushed along x into the middle of the height, so slowly that inertia and damping count for
/// nothing.
inline const Vec3 BLOCK(0.2, 0.1, 0.04);      // [m]
inline constexpr double YOUNG_MODULUS = 5e4;  // [Pa]

struct Push {
  int cells = 5;             ///< over the height; odd, so that the blade goes through elements
  bool progressive = true;   ///< as ToolSettings says
  double cutting_force = 0;  ///< F_c [N/m]
  double pull = 0;           ///< traction on the upper and the lower side, apart [Pa]
  double depth = 0.1;        ///< to which the blade goes [m]
  double stride = 5e-4;      ///< of the blade in a step [m]
};

/// After each step.
struct Trace {
  std::vector<double> depth;  ///< of the blade behind the face's place at rest [m]
  std::vector<double> force;  ///< of the tissue against the blade's way [N]
  std::vector<double> area;   ///< that the blade has cut [m²]
  std::vector<double>
      opening;  ///< how much farther apart the upper and the lower edge of the face are than at rest [m]
};

/// Edge of the cells [m].
double cellSize(int cells);

Trace push(const Push& setting);

/// Opening at rest under the pull of a block cut to a whole count of cells, `depth` [m], by a rectangle. No blade.
double openingAtRest(int cells, double pull, double depth);

}  // namespace incision::report
