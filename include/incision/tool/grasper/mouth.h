#pragma once

#include <Eigen/Geometry>
#include <array>
#include <vector>

#include "incision/rigid/jaw_links.h"

namespace incision {

/// The room between two jaws while their joint is at one angle, in the frame of the tool's link. A point is in it when
/// it comes upon one jaw on the way on which the jaws close, and upon the other on the way back:
///
///     ────────────  jaw
///          ↑
///          • between
///          ↓
///     ────────────  jaw
///
/// The jaws are the groups that move against the tool's link; where that is one alone, the link itself is the other.
class Mouth {
 public:
  Mouth(const JawLinks& links, double angle);

  /// Whether a point [m] lies between the jaws. One that has been pressed a little into a jaw counts as lying before
  /// it.
  bool isBetween(Vec3 point) const;

  /// Points spread evenly over the room [m]: any first ones of them are so too. None where there is no room.
  const std::vector<Vec3>& points() const { return points_; }

  /// The box round these points [m].
  const Eigen::AlignedBox3d& box() const { return box_; }

 private:
  struct Shape {
    SolidPtr solid;
    Eigen::Isometry3d pose;  // in the tool's link
  };
  using Jaw = std::vector<Shape>;

  static Jaw placed(const JawLinks& links, int group, double angle);
  static SolidDistance distanceTo(const Jaw& jaw, const Vec3& point);
  int firstMet(const Vec3& from, const Vec3& direction) const;
  void addRoomBefore(const Vec3& inside, const Vec3& direction, std::vector<Vec3>* points) const;
  std::vector<Vec3> inFirstJaw() const;

  JawLinks links_;
  std::array<Jaw, 2> jaws_;
  double reach_ = 0;    // how far the jaws may be apart [m]
  double pressed_ = 0;  // how deep in a jaw is a little [m]
  std::vector<Vec3> points_;
  Eigen::AlignedBox3d box_;
};

}  // namespace incision
