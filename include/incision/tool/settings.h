#pragma once

#include <optional>
#include <string>
#include <vector>

#include "incision/rigid/timed_pose.h"

namespace incision {

class YamlValue;

struct ToolSettings {
  std::string description = {};   ///< URDF file; may be empty when `edge` is given
  std::string link = {};          ///< the blade's link
  std::optional<Edge> edge = {};  ///< in the link's frame; absent: the longest edge of the link's first collision box
  std::vector<TimedPose> poses = {};  ///< of the link in the body's frame; between them the pose is interpolated
  std::string frame = {};             ///< tf frame of the link, from which its pose comes; empty: it comes in messages
  /// A pose that moves the link's origin or an end of the edge farther than this from where the pose before had it [m]
  /// begins a new stroke: more than a hand does between two poses, and less than an organ's size.
  double max_step = 0.1;
  /// A pose older than this by time of receipt [s] is stale, and the tool stays where it is: some poses of any stream.
  double timeout = 0.5;
  /// [N/m] of edge in the tissue: the fracture energy [J/m²] of what it cuts; regions may differ.
  double cutting_force = 0;
  double friction = 0.3;        ///< Coulomb's coefficient, of the edge along itself and of the link's shapes
  bool progressive = true;      ///< an element's crack opens as the blade sweeps it; false: elements are cut whole
  std::string poses_file = {};  ///< file of the poses, where it is still to be read
};

/// The section `tool`. Throws InputError.
ToolSettings parseTool(const YamlValue& value);

}  // namespace incision
