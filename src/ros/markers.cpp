#include "incision/ros/markers.h"

#include "incision/ros/conversions.h"
#include "plain_marker.h"

namespace incision {
namespace {

using visualization_msgs::Marker;

/// Of a plane as it is drawn [m]: as wide as a hall, and thin.
constexpr double GROUND_WIDTH = 100, GROUND_HEIGHT = 0.001;

/// Of the tool's edge as it is drawn [m].
constexpr double EDGE_WIDTH = 0.001;

/// Of the arrow of a force [m]: the diameters of its shaft and its head, and the head's length.
const Vec3 ARROW_SIZE(0.003, 0.006, 0.01);

int typeOf(Drawing::Primitive primitive) {
  if (primitive == Drawing::Primitive::SPHERE) return Marker::SPHERE;
  return primitive == Drawing::Primitive::CYLINDER ? Marker::CYLINDER : Marker::CUBE;
}

/// A solid that stands at `pose` in the marker's frame.
Marker markerOf(const Solid& solid, const Pose& pose, const std::string& what, int id,
                const std_msgs::ColorRGBA& colour, const std::string& frame, const ros::Time& stamp) {
  const Drawing drawing = solid.drawing();
  Marker marker = plainMarker(typeOf(drawing.primitive), what, id, colour, frame, stamp);
  marker.pose = toPoseMessage(pose);
  marker.scale = toVector3(drawing.size);
  if (drawing.primitive != Drawing::Primitive::HALF_SPACE) return marker;
  Pose below;
  below.position.z() = -GROUND_HEIGHT / 2;
  marker.pose = toPoseMessage(composed(pose, below));
  marker.scale = toVector3({GROUND_WIDTH, GROUND_WIDTH, GROUND_HEIGHT});
  return marker;
}

}  // namespace

visualization_msgs::MarkerArray toMarkers(const Obstacles& obstacles, const std::vector<Pose>& links,
                                          const std::string& frame, const ros::Time& stamp) {
  visualization_msgs::MarkerArray array;
  for (const Obstacle& obstacle : obstacles.shapes) {
    const bool is_ground = obstacle.link == GROUND_LINK;
    const auto link = static_cast<std::size_t>(obstacle.link);
    const Pose pose = is_ground ? obstacle.pose : composed(links[link], obstacle.pose);
    const int id = static_cast<int>(array.markers.size());
    array.markers.push_back(markerOf(*obstacle.solid, pose, is_ground ? "ground" : obstacles.links[link].name, id,
                                     colour(0.62F, 0.66F, 0.70F), frame, stamp));
  }
  return array;
}

visualization_msgs::MarkerArray toMarkers(const Obstacles& shapes, const Edge& edge, const ToolView& view,
                                          const std::string& frame, const ros::Time& stamp) {
  visualization_msgs::MarkerArray array;
  if (!view.pose) {
    array.markers = {plainMarker(Marker::CUBE, "", 0, colour(0, 0, 0), frame, stamp)};
    array.markers[0].action = Marker::DELETEALL;
    return array;
  }
  array.markers = {plainMarker(Marker::LINE_LIST, "edge", 0, colour(0.10F, 0.10F, 0.12F), frame, stamp),
                   plainMarker(Marker::ARROW, "force", 0, colour(0.95F, 0.65F, 0.10F), frame, stamp)};
  array.markers[0].scale.x = EDGE_WIDTH;
  for (const Vec3& end : placed(edge, *view.pose)) array.markers[0].points.push_back(toPoint(end));
  const Vec3 head = view.pose->position + FORCE_SCALE * (view.pose->orientation * view.force);
  array.markers[1].scale = toVector3(ARROW_SIZE);
  array.markers[1].points = {toPoint(view.pose->position), toPoint(head)};
  array.markers[1].action = view.force.isZero() ? Marker::DELETE : Marker::ADD;
  for (const Obstacle& shape : shapes.shapes) {
    const int id = static_cast<int>(array.markers.size());
    array.markers.push_back(markerOf(*shape.solid, composed(*view.pose, shape.pose), "shape", id,
                                     colour(0.75F, 0.77F, 0.80F), frame, stamp));
  }
  return array;
}

}  // namespace incision
