#pragma once

#include <array>
#include <optional>
#include <string>
#include <vector>

#include "incision/rigid/description.h"

namespace incision {

/// A tool's link and all that hangs on it, as the joint with which the tool opens and closes moves them. What moves
/// together is a group: group 0 is the tool's link with what is fixed to it, and each of the others, a jaw, hangs on
/// the tool's link by a joint that moves. The joint called so moves by the angle, those that mimic it go with it, and
/// all others stay at 0. A joint may slide instead of turning: then its angle is a length [m].
///
///                 ╱ group 1
///     group 0 ═══o                 closing turns the jaws to smaller angles
///                 ╲ group 2
///
class JawLinks {
 public:
  /// Most groups that move against the tool's link.
  static constexpr int MOST_JAWS = 2;

  /// Throws InputError where the description has no such link or joint, where the joint is not below the link, does not
  /// turn or slide, or mimics another one; where more than MOST_JAWS joints move shapes, or one of them hangs on
  /// another; and for a shape or a joint that cannot be used. Joints that move no shape are left out.
  JawLinks(const Description& description, const std::string& link, const std::string& joint);

  /// How many groups there are, group 0 included.
  int groups() const { return static_cast<int>(groups_.size()); }
  /// The shapes of a group, in its own frame, which is that of the jaw's joint.
  const std::vector<DescribedSolid>& solids(int group) const { return groups_[group].solids; }
  /// The name of the link to which the group's frame belongs.
  const std::string& name(int group) const { return groups_[group].link; }

  /// Where a group's frame stands in that of the tool's link while the joint is at `angle`.
  Pose pose(int group, double angle) const;

  /// How a point [m] that goes with a group moves as the angle grows [m/rad], both in the tool's link.
  Vec3 velocity(int group, const Vec3& point) const;

  /// Where a point of the tool's link [m] is driven by a joint of the first jaw that closes: along its axis where the
  /// joint slides, about it where it turns; of any length.
  Vec3 closing(const Vec3& point) const;

  /// What a wrench on a group, in the frame of the tool's link and about its origin, does to the joint [N m, or N where
  /// it slides]: positive where it drives it to larger angles. Zero for group 0.
  double effort(int group, const Wrench& wrench) const;

  /// The joint's limits, where it has some.
  const std::optional<std::array<double, 2>>& limits() const { return limits_; }

 private:
  /// How a group follows the angle.
  struct Group {
    std::string link;
    std::vector<DescribedSolid> solids = {};
    JointKind kind = JointKind::FIXED;
    double multiplier = 0, offset = 0;
    Pose origin = {};          // of its frame, the group's own coordinate at 0, in that of the tool's link
    Vec3 axis = Vec3::Zero();  // unit, in that of the tool's link

    /// How a point [m] of the tool's link moves with the group's own coordinate.
    Vec3 course(const Vec3& point) const {
      return kind == JointKind::PRISMATIC ? axis : Vec3(axis.cross(point - origin.position));
    }
  };
  class Builder;

  std::vector<Group> groups_;
  std::optional<std::array<double, 2>> limits_;
};

}  // namespace incision
