#pragma once

#include <string>
#include <vector>

#include "incision/rigid/pose.h"
#include "incision/rigid/solid.h"

namespace incision {

/// A collision of a link as it is described; nothing is checked.
struct DescribedSolid {
  SolidPtr solid;  ///< none where the description has a kind of solid that there is not, which is a mesh
  Pose pose;       ///< in its link's frame
};

struct DescribedLink {
  std::string name;
  Pose pose;  ///< in the root link's frame, all joints at 0
  std::vector<DescribedSolid> solids;
  std::string fault;  ///< why a solid that the text has is not among them; empty: all are
};

/// A robot, tool or room, read from a URDF once for all that use it.
struct Description {
  std::string name;                  ///< what errors call it
  std::vector<DescribedLink> links;  ///< parents before their children

  /// The link called so. Throws InputError where there is none.
  const DescribedLink& link(const std::string& link) const;
};

/// The links of a URDF and their collisions. `urdf` is the text, `name` what errors call it. Throws InputError, in one
/// line, when the text is no URDF or a hostile one.
Description parseDescription(const std::string& urdf, const std::string& name);

/// "name: link 'link'", fit for one line of a message.
std::string linkInMessage(const std::string& name, const std::string& link);

/// Throws InputError "where…" when there is no solid, or its size or pose is out of range or not finite.
void checkSolid(const DescribedSolid& described, const std::string& where);

/// Throws InputError "where…" when the pose is out of range or not finite.
void checkPose(const Pose& pose, const std::string& where);

}  // namespace incision
