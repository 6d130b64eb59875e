#pragma once

#include <array>

#include "incision/fracture/fringe.h"

namespace incision {

/// Most that a crack turns from one element to the next [rad]: a sharper bend, as at the kink from a notch under shear,
/// takes two elements. It keeps a crack from turning back where the stress is noise.
inline constexpr double MAX_TURN = 0.8;

/// A face at which a crack ends, and where it comes from.
struct Front {
  std::array<Vec3, 3> face;  ///< corners of the face [m], in the body as it is deformed
  Vec3 phi;                  ///< φ there [m], of both signs
  Vec3 behind;               ///< ∇φ in the element behind the face
};

Front frontOf(const Fringe& fringe, const GrowingCrack& crack, const CutMesh& mesh, const std::vector<Vec3>& x);

/// φ [m] at a point beyond the face such that the crack keeps its line on the face and, turning about it, comes as
/// close to the plane with this normal (of either sense) as MAX_TURN allows.
double phiBeyond(const Front& front, const Vec3& normal, const Vec3& point);

/// The middle of the crack's line on the face [m].
Vec3 middleOf(const Front& front);

/// Normal of the plane through the crack's line on the face and a point.
Vec3 normalTowards(const Front& front, const Vec3& point);

/// A point of a crack's face, for what comes near it.
struct CrackFace {
  int crack;
  int part;
  Barycentric point;
};

/// Corners and centroids of all facets that cracks have cut.
std::vector<CrackFace> crackFaces(const CutMesh& mesh);

}  // namespace incision
