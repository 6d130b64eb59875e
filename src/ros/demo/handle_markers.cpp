#include "incision/ros/demo/handle_markers.h"

#include <algorithm>

#include "incision/ros/conversions.h"

namespace incision {
namespace {

using visualization_msgs::InteractiveMarker;
using visualization_msgs::InteractiveMarkerControl;
using visualization_msgs::Marker;

/// Of rings and arrows, over the size of what they move: to be hit with the mouse, and not to hide the body.
constexpr double CONTROLS = 0.6;

/// Of the handle, over its length.
constexpr double HANDLE_THICKNESS = 0.07;

/// Of the rectangle, over its larger side: a sheet that is seen from its edge too.
constexpr double SHEET_THICKNESS = 0.005;

InteractiveMarker markerOf(const std::string& name, const std::string& frame, const Pose& pose, double size) {
  InteractiveMarker marker;
  marker.header.frame_id = frame;  // without a stamp, which locks it to the frame
  marker.name = name;
  marker.description = name;
  marker.pose = toPoseMessage(pose);
  marker.scale = static_cast<float>(CONTROLS * size);
  return marker;
}

/// What is seen and can be grabbed: the mouse moves it in the plane of the screen, and turns it with Ctrl held.
void addShape(const Marker& shape, InteractiveMarker* marker) {
  InteractiveMarkerControl control;
  control.name = "grab";
  control.interaction_mode = InteractiveMarkerControl::MOVE_ROTATE_3D;
  control.always_visible = true;
  control.markers = {shape};
  marker->controls.push_back(control);
}

/// An arrow along and a ring round each of the marker's own axes.
void addFreedoms(InteractiveMarker* marker) {
  for (int axis = 0; axis < 3; ++axis) {
    InteractiveMarkerControl control;  // it acts along, or round, its own x axis
    const auto to_axis = Eigen::Quaterniond::FromTwoVectors(Vec3::UnitX(), Vec3::Unit(axis));
    control.orientation = toPoseMessage({Vec3::Zero(), to_axis}).orientation;
    control.name = "move along " + std::string(1, "xyz"[axis]);
    control.interaction_mode = InteractiveMarkerControl::MOVE_AXIS;
    marker->controls.push_back(control);
    control.name = "turn round " + std::string(1, "xyz"[axis]);
    control.interaction_mode = InteractiveMarkerControl::ROTATE_AXIS;
    marker->controls.push_back(control);
  }
}

Marker shapeOf(int type, const Vec3& size, float opacity) {
  Marker shape;
  shape.type = type;
  shape.pose.orientation.w = 1;
  shape.scale = toVector3(size);
  shape.color.r = 0.25F, shape.color.g = 0.45F, shape.color.b = 0.75F, shape.color.a = opacity;
  return shape;
}

}  // namespace

InteractiveMarker toolHandle(const std::string& frame, const Pose& pose, double size, const Vec3& axis) {
  const double thickness = HANDLE_THICKNESS * size;
  Marker handle = shapeOf(Marker::CYLINDER, {thickness, thickness, size}, 1);
  handle.pose = toPoseMessage({-size / 2 * axis, Eigen::Quaterniond::FromTwoVectors(Vec3::UnitZ(), axis)});
  InteractiveMarker marker = markerOf(TOOL, frame, pose, size);
  addShape(handle, &marker);
  addFreedoms(&marker);
  return marker;
}

InteractiveMarker planeHandle(const std::string& frame, const Pose& pose, double length, double width) {
  const double size = std::max(length, width);
  InteractiveMarker marker = markerOf(PLANE, frame, pose, size);
  addShape(shapeOf(Marker::CUBE, {length, width, SHEET_THICKNESS * size}, 0.4F), &marker);
  addFreedoms(&marker);
  return marker;
}

}  // namespace incision
