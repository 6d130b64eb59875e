#pragma once

#include <visualization_msgs/InteractiveMarker.h>

#include <string>

#include "incision/rigid/pose.h"

namespace incision {

/// Names by which rviz tells which of the two the user has moved.
inline const std::string TOOL = "tool", PLANE = "plane";

/// A handle to grab, of length `size` [m], that ends at the tool's origin and extends against its `axis`; with rings
/// and arrows for its six freedoms. It is locked to `frame`, so rviz answers in it.
visualization_msgs::InteractiveMarker toolHandle(const std::string& frame, const Pose& pose, double size,
                                                 const Vec3& axis);

/// A translucent rectangle to grab, `length` [m] along its x axis and `width` [m] along y. It is locked to `frame` too.
visualization_msgs::InteractiveMarker planeHandle(const std::string& frame, const Pose& pose, double length,
                                                  double width);

}  // namespace incision
