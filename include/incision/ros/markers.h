#pragma once

#include <visualization_msgs/MarkerArray.h>

#include <string>
#include <vector>

#include "incision/contact/obstacles.h"
#include "incision/tool/tool_form.h"

namespace incision {

/// The obstacles' shapes, the ground among them, while their links are at these poses.
visualization_msgs::MarkerArray toMarkers(const Obstacles& obstacles, const std::vector<Pose>& links,
                                          const std::string& frame, const ros::Time& stamp);

/// How large what is drawn of tools is, beside their shapes.
struct ToolScale {
  double size;   ///< of the body [m], to which widths and letters go
  double force;  ///< length of the arrow of a force [m/N]
};

/// Where a tool is, and what the tissue does to it.
struct ToolView {
  std::string name;
  std::vector<Pose> groups;   ///< of what of it moves together, in the body's frame; none: it is not in place
  Vec3 force = Vec3::Zero();  ///< of the tissue on the tool, in the frame of its link [N]
};

/// Tools: their shapes, their edges as lines, and the forces on them as arrows from the links' origins, with how many N
/// they are. Those of a tool that is not in place are deleted.
visualization_msgs::MarkerArray toMarkers(const std::vector<ToolForm>& forms, const std::vector<ToolView>& views,
                                          const ToolScale& scale, const std::string& frame, const ros::Time& stamp);

}  // namespace incision
