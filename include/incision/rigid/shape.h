#pragma once

#include "incision/base/vec.h"

namespace incision {

/// HALF_SPACE is all of z ≤ 0; the others are centred on the origin, the cylinder's axis along z.
enum class ShapeKind { HALF_SPACE, SPHERE, BOX, CYLINDER };

/// A rigid solid in its own frame.
struct Shape {
  ShapeKind kind = ShapeKind::HALF_SPACE;
  /// [m], above 0 where it means something. Box: edge lengths; sphere: radius in [0]; cylinder: radius in [0], length
  /// in [2]; half space: none.
  Vec3 size = Vec3::Zero();
};

struct ShapeDistance {
  double distance = 0;          ///< of the point from the nearest point of the surface [m], negative inside
  Vec3 normal = Vec3::UnitZ();  ///< the surface's outward unit normal there; at an edge or a corner, towards the point
};

/// Where a finite point, given in the shape's frame, lies against the shape. The normal is the distance's gradient
/// where it has one; where several surface points are equally near, as at a centre or on an axis, it is that of one of
/// them.
ShapeDistance distanceTo(const Shape& shape, const Vec3& point);

/// A face opposes a normal where the two are against each other by this cosine at least. One of a box's always is.
inline constexpr double LEAST_OPPOSITION = 0.3;

/// Where a point lies against the face of the shape, nearest of those that oppose `n`, the unit normal of a surface
/// that the point is on, both in the shape's frame: there the point comes out on the side of what the surface bounds,
/// however far that is. The face is taken for the whole of its plane.
ShapeDistance distanceAgainst(const Shape& shape, const Vec3& point, const Vec3& n);

/// Smallest distance of two parallel planes between which the shape fits [m]. Infinite for a half space.
double thickness(const Shape& shape);

/// Largest n·q over the points q of the shape, for a unit vector n: how far it reaches that way [m]. Infinite for a
/// half space, but along its normal.
double reachAlong(const Shape& shape, const Vec3& n);

}  // namespace incision
