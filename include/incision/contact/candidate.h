#pragma once

#include "incision/solver/coupling.h"

namespace incision {

/// The contact is this much stiffer than the layer of elements it lies on: κ = STIFFNESS E/h [Pa/m]. A pressure p then
/// presses in by p h/(STIFFNESS E): below 1 % of an element up to p = E. More costs iterations between pieces.
inline constexpr double CONTACT_STIFFNESS = 100;

/// Depth, in elements, beyond which the push does not grow any more: what begins deep inside is brought out over some
/// steps, not shot out in one.
inline constexpr double MAX_PUSH = 0.1;

/// A place where a point of the surface may touch a plane in this step.
struct Candidate {
  int sample;        ///< of the ContactSurface; for obstacles the vertex
  int partner;       ///< the obstacle, or BODY
  Vec3 normal;       ///< n, unit, from the partner to the point
  double gap;        ///< g [m] when the step starts, negative inside
  Vec3 drift;        ///< of the partner in the step, where it is an obstacle [m]
  double stiffness;  ///< k [N/m]
  double size;       ///< h of the elements there [m]
  Vec3 slip;         ///< s, tangential: how far the point has dragged on the partner, elastically [m]
  Coupling held;     ///< y: the point less what it meets on the body; its stiffness and force are for update()

  static constexpr int BODY = -1;
};

}  // namespace incision
