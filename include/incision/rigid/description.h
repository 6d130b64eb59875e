#pragma once

#include <string>
#include <vector>

#include "incision/rigid/pose.h"
#include "incision/rigid/shape.h"

namespace incision {

/// A collision shape as it is described; nothing is checked.
struct DescribedShape {
  bool is_mesh = false;  ///< then there is no `shape`
  Shape shape;           ///< sphere, box or cylinder
  Pose pose;             ///< in its link's frame
};

struct DescribedLink {
  std::string name;
  Pose pose;  ///< in the root link's frame, all joints at 0
  std::vector<DescribedShape> shapes;
  std::string fault;  ///< why a shape that the text has is not among them; empty: all are
};

/// The links of a URDF and their collision shapes, parents before their children. `urdf` is the text, `name` what
/// errors call it. Throws InputError, in one line, when the text is no URDF or a hostile one.
std::vector<DescribedLink> parseDescription(const std::string& urdf, const std::string& name);

/// The link called so. Throws InputError where there is none; `name` is what errors call the description.
const DescribedLink& findLink(const std::vector<DescribedLink>& links, const std::string& link,
                              const std::string& name);

/// "name: link 'link'", fit for one line of a message.
std::string linkInMessage(const std::string& name, const std::string& link);

/// Throws InputError "where…" when a shape that is no mesh has a size or a pose out of range or not finite.
void checkShape(const DescribedShape& shape, const std::string& where);
/// The same for a pose.
void checkPose(const Pose& pose, const std::string& where);

}  // namespace incision
