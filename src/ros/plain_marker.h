#pragma once

#include <visualization_msgs/Marker.h>

#include <string>

namespace incision {

inline std_msgs::ColorRGBA colour(float r, float g, float b) {
  std_msgs::ColorRGBA c;
  c.r = r, c.g = g, c.b = b, c.a = 1;
  return c;
}

/// A marker without points, at the frame's origin.
inline visualization_msgs::Marker plainMarker(int type, const std::string& what, int id,
                                              const std_msgs::ColorRGBA& colour, const std::string& frame,
                                              const ros::Time& stamp) {
  visualization_msgs::Marker marker;
  marker.header.frame_id = frame;
  marker.header.stamp = stamp;
  marker.ns = what;
  marker.id = id;
  marker.type = type;
  marker.pose.orientation.w = 1;
  marker.scale.x = marker.scale.y = marker.scale.z = 1;
  marker.color = colour;
  return marker;
}

}  // namespace incision
