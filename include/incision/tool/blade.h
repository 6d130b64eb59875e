#pragma once

#include <array>
#include <optional>
#include <string>
#include <vector>

#include "incision/contact/pose.h"

namespace incision {

/// A pose of the tool's blade link in the body's frame.
struct TimedPose {
  double time = 0;  ///< [s]
  Pose pose;
};

/// A cutting edge: its two ends [m].
using Edge = std::array<Vec3, 2>;

struct ToolSettings {
  std::string description;       ///< URDF file; may be empty when `edge` is given
  std::string link;              ///< the blade's link
  std::optional<Edge> edge;      ///< in the link's frame; absent: the longest edge of the link's first collision box
  std::vector<TimedPose> poses;  ///< ascending times; between them the pose is interpolated
};

/// The cutting edge in the blade link's frame: the tool's own, or else the longest edge of the link's first collision
/// box. Of the four equal edges along the box's longest axis (of equal axes the first) it is the one where the other
/// two of the box's coordinates are smallest. `urdf` is the text of the description, `name` what errors call it.
/// Throws InputError when the description is unreadable or hostile, lacks the link, or gives no edge.
Edge bladeEdge(const ToolSettings& tool, const std::string& urdf, const std::string& name);

/// The edge carried to a pose.
Edge placed(const Edge& edge, const Pose& pose);

}  // namespace incision
