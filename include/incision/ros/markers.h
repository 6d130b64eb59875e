#pragma once

#include <visualization_msgs/MarkerArray.h>

#include <string>

#include "incision/contact/obstacles.h"
#include "incision/surface/surface.h"

namespace incision {

/// The surface as two lists of triangles, the skin and the cut faces, of the same points as long as the topology does
/// not change. One with no triangles is deleted. `x`: positions of the copies [m], finite.
visualization_msgs::MarkerArray toMarkers(const Surface& surface, const std::vector<Vec3>& x, const std::string& frame,
                                          const ros::Time& stamp);

/// The obstacles' shapes, the ground among them, while their links are at these poses.
visualization_msgs::MarkerArray toMarkers(const Obstacles& obstacles, const std::vector<Pose>& links,
                                          const std::string& frame, const ros::Time& stamp);

}  // namespace incision
