#pragma once

#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "incision/rigid/timed_angle.h"
#include "incision/rigid/timed_pose.h"
#include "incision/tool/blade/settings.h"
#include "incision/tool/grasper/settings.h"
#include "incision/tool/probe/settings.h"
#include "incision/tool/scissors/settings.h"

namespace incision {

class YamlValue;

/// The joint with which a tool opens and closes.
struct JawSettings {
  std::string joint;               ///< of the description
  std::vector<TimedAngle> angles;  ///< of it, those of `jaw`; between them it is interpolated
  std::string file;                ///< of the angles, where it is still to be read
};

/// What one kind of tool has and others have not; the alternatives stand in the order of toolKinds().
using KindSettings = std::variant<BladeSettings, GrasperSettings, ProbeSettings, ScissorsSettings>;

struct ToolSettings {
  std::string name = "tool";          ///< of letters, digits and _; no other tool of the scene has it
  std::string description = {};       ///< URDF file; empty where the tool needs none
  std::string link = {};              ///< of the description: the one that poses move
  KindSettings kind = {};             ///< what it is
  std::vector<TimedPose> poses = {};  ///< of the link in the body's frame; between them the pose is interpolated
  std::string poses_file = {};        ///< of the poses, where it is still to be read
  std::string frame = {};             ///< tf frame of the link, from which its pose comes; empty: it comes in messages
  std::optional<JawSettings> jaw = {};
  /// A pose that moves the tool's link farther than this from where the pose before had it [m] begins a new stroke:
  /// more than a hand does between two poses, and less than an organ's size.
  double max_step = 0.1;
  /// A pose older than this by time of receipt [s] is stale, and the tool stays where it is: some poses of any stream.
  double timeout = 0.5;
  double friction = 0.3;  ///< Coulomb's coefficient, of the link's shapes and of an edge along itself
};

/// Most tools of a scene: far more than surround a table, and few enough for a topic of each.
inline constexpr std::size_t MAX_TOOLS = 100;

/// The section `tools`, by name, so that the order in the file does not matter. Throws InputError.
std::vector<ToolSettings> parseTools(const YamlValue& value);

}  // namespace incision
