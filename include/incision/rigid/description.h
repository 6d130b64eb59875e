#pragma once

#include <array>
#include <optional>
#include <string>
#include <vector>

#include "incision/rigid/pose.h"
#include "incision/rigid/solid.h"

namespace incision {

/// A collision of a link as it is described; nothing is checked.
struct DescribedSolid {
  SolidPtr solid;
  Pose pose;  ///< in its link's frame
};

struct DescribedLink {
  std::string name;
  Pose pose;  ///< in the root link's frame, all joints at 0
  std::vector<DescribedSolid> solids;
  std::string fault;  ///< why a solid that the text has is not among them; empty: all are
};

/// How a joint lets its child move against its parent.
enum class JointKind {
  FIXED,      ///< not at all
  REVOLUTE,   ///< it turns about the axis, with limits or without
  PRISMATIC,  ///< it slides along the axis
  OTHER,      ///< in more than one way
};

/// A joint as it is described; nothing is checked.
struct DescribedJoint {
  /// It goes with another joint: at multiplier × that one's coordinate + offset.
  struct Mimic {
    std::string joint;
    double multiplier = 1, offset = 0;
  };

  std::string name;
  JointKind kind = JointKind::FIXED;
  int parent = 0, child = 0;  ///< indices of the description's links
  Pose origin;                ///< of the child's frame in the parent's, the joint at 0
  Vec3 axis = Vec3::UnitX();  ///< in the child's frame, of any length
  std::optional<Mimic> mimic;
  std::optional<std::array<double, 2>> limits;  ///< of its coordinate [rad or m], where there is room between them
};

/// A robot, tool or room, read from a URDF once for all that use it.
struct Description {
  std::string name;                  ///< what errors call it
  std::vector<DescribedLink> links;  ///< parents before their children
  std::vector<DescribedJoint> joints =
      {};  ///< likewise: one for each link but the first, in the order of their children

  /// The link called so, by its index too. Throws InputError where there is none.
  const DescribedLink& link(const std::string& link) const;
  int linkIndex(const std::string& link) const;
  /// The index of the joint called so. Throws InputError where there is none.
  int jointIndex(const std::string& joint) const;
};

/// The links of a URDF, their collisions, and the joints between them. Capsules are read too (`<capsule radius
/// length/>`, as Drake and later URDF have it). `urdf` is the text, `name` what errors call it: where that is its file,
/// relative paths of meshes start from the file's folder. Meshes are read when they are checked, or first asked for
/// something. Throws InputError, in one line, when the text is no URDF, one that xacro has still to expand, or a
/// hostile one.
Description parseDescription(const std::string& urdf, const std::string& name);

/// "name: link 'link'", fit for one line of a message.
std::string linkInMessage(const std::string& name, const std::string& link);

/// "name: joint 'joint'", likewise.
std::string jointInMessage(const std::string& name, const std::string& joint);

/// Throws InputError "where…" when the solid's size or its pose is out of range or not finite, or it is a mesh that
/// cannot be read.
void checkSolid(const DescribedSolid& described, const std::string& where);

/// Throws InputError "where…" when the pose is out of range or not finite.
void checkPose(const Pose& pose, const std::string& where);

}  // namespace incision
