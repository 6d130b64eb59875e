#pragma once

#include <string>
#include <vector>

#include "incision/contact/settings.h"
#include "incision/rigid/description.h"

namespace incision {

/// `Obstacle::link` of the ground, which belongs to no link and never moves.
inline constexpr int GROUND_LINK = -1;

/// A rigid solid that the body cannot enter.
struct Obstacle {
  SolidPtr solid;
  Pose pose;  ///< in its link's frame; the ground's in the body's
  int link = GROUND_LINK;
};

struct ObstacleLink {
  std::string name;  ///< also that of its tf frame
  Pose pose;         ///< in the body's frame, as described
};

struct Obstacles {
  std::vector<ObstacleLink> links;  ///< those that have shapes
  std::vector<Obstacle> shapes;
};

/// Most collision shapes of a description. Each is compared with the whole body in each step, and a robot in a
/// furnished room has a tenth of it.
inline constexpr std::size_t MAX_OBSTACLES = 1000;

/// The ground, and all collision shapes of the description where the settings name one. Its root link stands at the
/// origin of the body's frame, and all joints at 0. `urdf` is the text of the description, `name` what errors call it.
/// Throws InputError when the description is unreadable or hostile, when it has no collision shape or too many, or one
/// that has a size that is not positive, lies out of range, or is a mesh that cannot be read.
Obstacles loadObstacles(const ContactSettings& settings, const std::string& urdf, const std::string& name);

/// The collision shapes of one link of a description, if it has any; they belong to link 0. Throws InputError for the
/// shapes for which loadObstacles does, and where there is no such link.
Obstacles loadLink(const Description& description, const std::string& link);

/// One sentence for each link and each shape of it that was mended when it was read, such as a mesh that had holes.
std::vector<std::string> remarksOn(const Obstacles& obstacles);

}  // namespace incision
