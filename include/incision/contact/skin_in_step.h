#pragma once

#include <vector>

#include "incision/contact/contact_surface.h"

namespace incision {

/// The surface in a step in which nothing new acts.
struct SkinInStep {
  const ContactSurface& surface;
  const std::vector<Vec3>& x;               ///< where its vertices are when the step starts [m]
  const std::vector<Vec3>& ahead;           ///< how far they go [m]
  const std::vector<Vec3>& normals;         ///< of each triangle when the step starts, unit or zero
  const std::vector<Vec3>& end_normals;     ///< and when it ends
  const std::vector<Vec3>& sample_normals;  ///< of each sample when the step starts, unit or zero

  /// Where a vertex is after this share of the step [m].
  Vec3 at(int vertex, double share) const { return x[vertex] + share * ahead[vertex]; }
};

/// Depths up to so many elements are still contacts.
inline constexpr double MAX_DEPTH = 0.1;

/// What a triangle is wider than it is, as a share of it, so that a point above an edge falls on one of its two sides.
inline constexpr double RIM = 1e-2;

}  // namespace incision
