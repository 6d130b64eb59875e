#pragma once

#include <visualization_msgs/MarkerArray.h>

#include <optional>
#include <string>

#include "incision/contact/obstacles.h"

namespace incision {

/// The obstacles' shapes, the ground among them, while their links are at these poses.
visualization_msgs::MarkerArray toMarkers(const Obstacles& obstacles, const std::vector<Pose>& links,
                                          const std::string& frame, const ros::Time& stamp);

/// How long the arrow of a force is [m/N]: those of blades in soft tissue, up to some 10 N, fit the view.
inline constexpr double FORCE_SCALE = 0.02;

/// Where a tool is, and what the tissue does to it.
struct ToolView {
  std::optional<Pose> pose;   ///< in the body's frame; none: there is no tool in place
  Vec3 force = Vec3::Zero();  ///< of the tissue on the tool, in the frame of its link [N]
};

/// A tool's shapes, if it has any, its edge as a line, and the force on it as an arrow from the link's origin. No tool
/// in place: deletes them all.
visualization_msgs::MarkerArray toMarkers(const Obstacles& shapes, const Edge& edge, const ToolView& view,
                                          const std::string& frame, const ros::Time& stamp);

}  // namespace incision
