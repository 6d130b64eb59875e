#pragma once

#include <memory>
#include <optional>
#include <string>

#include "incision/rigid/pose.h"
#include "incision/rigid/triangle_mesh.h"

namespace incision {

struct SolidDistance {
  double distance = 0;          ///< of the point from the nearest point of the surface [m], negative inside
  Vec3 normal = Vec3::UnitZ();  ///< the surface's outward unit normal there; at an edge or a corner, towards the point
};

/// What a solid looks like, in its own frame, for those who draw it.
struct Drawing {
  enum class Primitive {
    BOX,         ///< centred on the origin
    SPHERE,      ///< centred on the origin
    CYLINDER,    ///< centred on the origin, its axis along z
    HALF_SPACE,  ///< z = 0, which has no end
    CAPSULE,     ///< centred on the origin, its axis along z
    MESH,        ///< `file` where there is one, else `mesh`
  };
  Primitive primitive = Primitive::BOX;
  Vec3 size = Vec3::Zero();  ///< edge lengths of the box round it [m]; none of a plane; of a mesh how it is stretched
  std::string file = {};     ///< of a mesh: a package:// or file:// address
  std::shared_ptr<const TriangleMesh> mesh = nullptr;
};

/// A face opposes a normal where the two are against each other by this cosine at least. One of a box's always is.
inline constexpr double LEAST_OPPOSITION = 0.3;

/// A rigid thing that touches, in its own frame. It never changes, so that many can share one.
class Solid {
 public:
  Solid() = default;
  Solid(const Solid&) = delete;
  Solid& operator=(const Solid&) = delete;
  virtual ~Solid() = default;

  /// Where a finite point lies against the solid. The normal is the distance's gradient where it has one; where several
  /// surface points are equally near, for example at a centre or on an axis, it is that of one of them.
  virtual SolidDistance distanceTo(const Vec3& point) const = 0;

  /// Where a point lies against the face of the solid, nearest of those that oppose `n`, the unit normal of a surface
  /// that the point is on: there the point comes out on the side of what the surface bounds, however far that is. The
  /// face is taken for the whole of its plane. The distance is −∞ where no face opposes `n`.
  virtual SolidDistance distanceAgainst(const Vec3& point, const Vec3& n) const = 0;

  /// Smallest distance of two parallel planes between which the solid fits [m]. Infinite for a half space.
  virtual double thickness() const = 0;

  /// Largest n·q over the points q of the solid, for a unit vector n [m]. Infinite for a half space, but along its
  /// normal.
  virtual double reachAlong(const Vec3& n) const = 0;

  /// Radius of the smallest ball round the origin that encloses the solid [m]. Infinite for a half space.
  virtual double reach() const = 0;

  /// Whether all between two of its points belongs to it.
  virtual bool isConvex() const { return true; }

  /// Whether a point is surely further than `room` [m] from all points of the solid. To say so is quick, and so it may
  /// be false for points that are.
  virtual bool isClearOf(const Vec3& /*point*/, double /*room*/) const { return false; }

  /// What was mended where the solid was read, if anything, for those who gave it.
  virtual std::string remark() const { return ""; }

  /// The edge with which a blade of this form cuts, if it has one.
  virtual std::optional<Edge> edge() const { return std::nullopt; }

  /// Throws InputError "where: …" when one of its sizes is out of range or not finite. A solid that fails may be
  /// thrown away, and nothing else.
  virtual void check(const std::string& where) const = 0;

  virtual Drawing drawing() const = 0;
};

using SolidPtr = std::shared_ptr<const Solid>;

}  // namespace incision
