#include "incision/ros/markers.h"

#include "incision/ros/conversions.h"

namespace incision {
namespace {

using visualization_msgs::Marker;

std_msgs::ColorRGBA colour(float r, float g, float b) {
  std_msgs::ColorRGBA c;
  c.r = r, c.g = g, c.b = b, c.a = 1;
  return c;
}

Marker emptyMarker(const std::string& what, int id, const std_msgs::ColorRGBA& colour, const std::string& frame,
                   const ros::Time& stamp) {
  Marker marker;
  marker.header.frame_id = frame;
  marker.header.stamp = stamp;
  marker.ns = what;
  marker.id = id;
  marker.type = Marker::TRIANGLE_LIST;
  marker.pose.orientation.w = 1;
  marker.scale.x = marker.scale.y = marker.scale.z = 1;
  marker.color = colour;
  return marker;
}

}  // namespace

visualization_msgs::MarkerArray toMarkers(const Surface& surface, const std::vector<Vec3>& x, const std::string& frame,
                                          const ros::Time& stamp) {
  visualization_msgs::MarkerArray array;
  array.markers = {emptyMarker("skin", 0, colour(0.78F, 0.35F, 0.32F), frame, stamp),
                   emptyMarker("cut faces", 1, colour(1.0F, 0.72F, 0.66F), frame, stamp)};
  const std::vector<Vec3> positions = surfacePositions(surface, x);
  for (std::size_t t = 0; t < surface.triangles.size(); ++t)
    for (const int vertex : surface.triangles[t])
      array.markers[surface.cut_face[t] ? 1 : 0].points.push_back(toPoint(positions[vertex]));
  // rviz calls a list without points an error.
  for (Marker& marker : array.markers) marker.action = marker.points.empty() ? Marker::DELETE : Marker::ADD;
  return array;
}

}  // namespace incision
